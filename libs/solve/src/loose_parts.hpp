// Parts of the body that nothing but contact holds.
#pragma once

#include <optional>
#include <vector>

#include "cleft/assembly/assembler.hpp"
#include "cleft/solve/linear_solver.hpp"

namespace cleft::solve {

/// The unknowns (not their components) of all parts without a prescribed component.
std::vector<Index> loose_unknowns(const assembly::Model& model, const std::vector<assembly::Constraint>& constraints);

/// For a tangent that is singular as a loose part may slide or turn: the correction with soft springs on such parts.
/// They are in the tangent only, so that what the iteration converges to is in balance without them, and a part that
/// bears no load stays where it is. Nothing if there is no loose part, or one moves by more than `bound` (metres).
std::optional<VecX> correction_with_parts_held(const assembly::Model& model,
                                               const std::vector<assembly::Constraint>& constraints, const VecX& rhs,
                                               double bound, assembly::BlockMatrix& matrix, LinearSolver& solver);

}  // namespace cleft::solve
