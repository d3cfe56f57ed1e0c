// Where an increment's iteration begins.
#pragma once

#include <vector>

#include "cleft/assembly/state.hpp"

namespace cleft::solve {

/// The displacement that the last increment leads to if it goes on to `load`. Nothing where there was none, or where
/// it would miss what is now prescribed (`target`, metres) by more than half of the boundary's motion.
std::optional<VecX> continued(const assembly::State& state, const std::vector<assembly::Constraint>& constraints,
                              const VecX& target, double load);

}  // namespace cleft::solve
