// Parts of the body that nothing but contact holds.
#pragma once

#include <optional>
#include <vector>

#include "cleft/assembly/assembler.hpp"
#include "cleft/assembly/linear_solver.hpp"

namespace cleft::assembly {

/// The unknowns (not their components) of all parts without a prescribed component.
std::vector<Index> loose_unknowns(const Model& model, const std::vector<Constraint>& constraints);

/// For a tangent that is singular as a loose part may slide or turn: the correction with soft springs on such parts.
/// They are in the tangent only, so that what the iteration converges to is in balance without them, and a part that
/// bears no load stays where it is. Nothing if there is no loose part, or one moves by more than `bound` (metres).
std::optional<VecX> correction_with_parts_held(const Model& model, const std::vector<Constraint>& constraints,
                                               const VecX& rhs, double bound, BlockMatrix& matrix,
                                               LinearSolver& solver);

}  // namespace cleft::assembly
