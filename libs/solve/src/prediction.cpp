#include "prediction.hpp"

#include <algorithm>
#include <cmath>

namespace cleft::solve {

std::optional<VecX> continued(const assembly::State& state, const std::vector<assembly::Constraint>& constraints,
                              const VecX& target, double load) {
  constexpr double kSameWay = 0.5;  // of the boundary's motion: what goes on in another way is no guide
  const double before = state.load - state.previous_load;
  if (!(before > 0.0)) return std::nullopt;
  VecX guess = state.displacement + ((load - state.load) / before) * (state.displacement - state.previous_displacement);
  double missed = 0.0, moved = 0.0;
  for (std::size_t k = 0; k < constraints.size(); ++k) {
    const Index c = constraints[k].component;
    missed = std::max(missed, std::fabs(target[k] - guess[c]));
    moved = std::max(moved, std::fabs(target[k] - state.displacement[c]));
  }
  if (missed > kSameWay * moved) return std::nullopt;
  return guess;
}

}  // namespace cleft::solve
