// Factors of the tangent matrix within an increment.
#pragma once

#include <vector>

#include "cleft/assembly/assembler.hpp"
#include "cleft/solve/linear_solver.hpp"
#include "cleft/solve/newton.hpp"

namespace cleft::solve {

/// Factorises the matrix once more with the least stiffness everywhere, which is added to it. Where flow goes on
/// without resistance the matrix is singular, and a load that rises along the path with it: this leaves the direction
/// of the flow to the path's equation, and the forces are exact all the same.
Factors factorise_propped(const assembly::Model& model, assembly::BlockMatrix& matrix, LinearSolver& solver);

/// Pivots without those that are negative because a constraint on a gap or slip decides a traction: the determinant
/// then tells of the body.
Pivots pivots_of_body(const LinearSolver& solver, const assembly::Assembler& assembler);

/// Whether the factors of the iteration before do for one more correction, which is the last: after a Newton step the
/// error is of second order in that step. It took the residual from r1 to r2, and the same factors take it from r2 to
/// about 2 r2^2 / r1.
bool old_factors_do(const std::vector<Iteration>& before, const Iteration& now, const NewtonControls& controls);

}  // namespace cleft::solve
