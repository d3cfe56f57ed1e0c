// What contact remembers of an increment, and its part of the energies.
#pragma once

#include "cleft/assembly/assembler.hpp"

namespace cleft::solve {

/// Takes an increment that has converged: the assembler and `pairs` hold its end, `before` the displacements at its
/// begin.
void commit_contact(const assembly::Model& model, const assembly::Assembler& assembler, const VecX& before,
                    const std::vector<contact::Pair>& pairs, assembly::History& history, assembly::Energies& energies);

}  // namespace cleft::solve
