// The correction that solves the complementarity problem of the multipliers exactly, with all else linear.
#pragma once

#include <optional>

#include "bordered.hpp"
#include "cleft/assembly/assembler.hpp"

namespace cleft::solve {

/// Newton's correction `du` from the displacements `u` keeps every hat open, sticking or slipping as it is there. This
/// is what joins it so that all of them are, in the linearised problem, what they should be after both (the step of
/// Josephy and Newton): the responses to changes of their conditions, two solutions of the system for each, make a
/// small problem of its own. Nothing where that has no solution that is found. The assembler is left with other
/// conditions at `u`.
std::optional<Correction> contact_step(const assembly::Model& model, const assembly::History& history, const VecX& u,
                                       const VecX& du, assembly::Assembler& assembler, const Bordered& system);

}  // namespace cleft::solve
