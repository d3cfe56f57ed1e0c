// The correction that solves the contact of the hats exactly where all else is linear.
#pragma once

#include <optional>

#include "cleft/assembly/assembler.hpp"
#include "cleft/assembly/linear_solver.hpp"

namespace cleft::assembly {

/// Newton's correction `du` from the displacements `u` keeps every hat open, sticking or slipping as it is there. This
/// is the correction with which all of them are, in the linearised problem, what they should be after it (the step of
/// Josephy and Newton): the responses to changes of their conditions, two solutions with the factors of `solver` for
/// each, make a small problem of its own. Nothing where that has no solution that is found. The assembler is left with
/// other conditions at `u`.
std::optional<VecX> contact_step(const Model& model, const History& history, const VecX& u, const VecX& du,
                                 Assembler& assembler, LinearSolver& solver);

}  // namespace cleft::assembly
