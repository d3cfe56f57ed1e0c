#include "bracket.hpp"

#include <algorithm>

namespace cleft::growth {

// theory (10.8)
double next_look(const Bracket& b, double tolerance, bool halve) {
  const double width = b.high - b.low;
  const double crossing = b.low + width * (1.0 - b.demand_low) / (b.demand_high - b.demand_low);
  const double guess = crossing - b.low <= 0.75 * tolerance ? crossing + 0.25 * tolerance : crossing - 0.5 * tolerance;
  const double middle = b.low + 0.5 * width, margin = std::min(0.25 * tolerance, 0.1 * width);
  return halve ? middle : std::clamp(guess, b.low + margin, b.high - margin);
}

}  // namespace cleft::growth
