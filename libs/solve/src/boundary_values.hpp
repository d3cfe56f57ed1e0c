// Prescribed components in the linear system of an iteration.
#pragma once

#include <vector>

#include "cleft/assembly/block_matrix.hpp"
#include "cleft/assembly/model.hpp"

namespace cleft::solve {

/// By how much each constraint's component of `u` is to change to its target, metres.
VecX missing_motion(const std::vector<assembly::Constraint>& constraints, const VecX& target, const VecX& u);

/// Takes what the change of the prescribed components does to the others to the right-hand side, and the change itself
/// into it, times the `diagonal` of their rows (N/m^2).
void prescribe(const std::vector<assembly::Constraint>& constraints, const VecX& change, double diagonal,
               const assembly::BlockMatrix& matrix, VecX& rhs);

/// Replaces the rows and columns of the prescribed components by a diagonal, so that the matrix keeps its symmetry.
void eliminate(const std::vector<assembly::Constraint>& constraints, double diagonal, assembly::BlockMatrix& matrix);

/// Puts the prescribed components of `u` where they belong: nothing is missing any more.
void move_boundary(const std::vector<assembly::Constraint>& constraints, const VecX& target, VecX& u, VecX& change);

}  // namespace cleft::solve
