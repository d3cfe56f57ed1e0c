#include "tally.hpp"

namespace cleft::tangent_check {

bool count(TangentBlock& block, TangentEntry entry, const Quotient& difference, double tolerance) {
  if (!is_certain(difference, entry.scale, tolerance)) {
    ++block.left_out;
    return false;
  }
  entry.difference = difference.value;
  entry.uncertainty = difference.uncertainty;
  entry.scale = std::fmax(entry.scale, std::fabs(difference.value));
  ++block.entries;
  if (block.entries == 1 || !(entry.error() <= block.worst.error())) block.worst = entry;
  return true;
}

}  // namespace cleft::tangent_check
