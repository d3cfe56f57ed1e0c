// Which kinds of elements and contact points contribute to an entry of the tangent.
#pragma once

#include <string>
#include <unordered_map>

#include "cleft/assembly/assembler.hpp"

namespace cleft::verify {

/// The unknowns whose forces a pair makes, and those on which these depend.
struct PairUnknowns {
  std::vector<Index> rows, columns;
};
PairUnknowns unknowns_of(const assembly::Model& model, const contact::Pair& pair, const contact::Memory& memory,
                         Index point);

/// Kinds of contributions by block (row unknown, column unknown).
class Labels {
 public:
  static Labels of_bulk(const assembly::Model& model);
  static Labels of_contact(const assembly::Model& model, const std::vector<contact::Pair>& pairs,
                           const std::vector<contact::Memory>& memory);

  /// "bulk", "bulk left", "contact slip, ramp", ...; several kinds joined by " + ". Empty where nothing contributes.
  std::string name(Index row, Index column) const;

 private:
  using Key = std::uint64_t;
  static Key key(Index row, Index column) {
    return (static_cast<Key>(static_cast<std::uint32_t>(row)) << 32) | static_cast<std::uint32_t>(column);
  }
  std::vector<std::string> kinds_;
  std::unordered_map<Key, unsigned> kinds_of_;
};

}  // namespace cleft::verify
