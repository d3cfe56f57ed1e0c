// What a converged increment leaves in the state.
#pragma once

#include "cleft/solve/newton.hpp"

namespace cleft::solve {

/// An increment that has converged; the assembler holds its end.
struct Converged {
  const assembly::Model& model;
  const std::vector<assembly::Constraint>& constraints;
  const assembly::Assembler& assembler;
  const Increment& increment;
};

/// Takes it into the state, which is that at its begin: energies, what material and contact remember, forces at the
/// constraints, load and displacement. The account of energies stays open (Energies::end_increment).
void commit_increment(const Converged& converged, assembly::State& state);

/// Forces at rounding do work, too, where a body moves without strain: an imbalance below this tells nothing, J/m.
double rounding_of_energy(const assembly::Model& model, const VecX& displacement);

}  // namespace cleft::solve
