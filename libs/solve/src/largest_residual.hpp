// Where an iterate is farthest from balance.
#pragma once

#include "cleft/solve/newton.hpp"

namespace cleft::solve {

/// `residual` is that of all unknowns with nothing in the prescribed ones, N/m. Where contact acts on the
/// node, the nearest point that presses is named; where material points at the node flow, the one that flows most.
LargestResidual largest_residual(const assembly::Model& model, const assembly::Assembler& assembler,
                                 const assembly::History& history, const VecX& residual);

}  // namespace cleft::solve
