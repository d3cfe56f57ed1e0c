// Where an iterate is farthest from balance.
#pragma once

#include "cleft/solve/newton.hpp"

namespace cleft::solve {

/// `residual` is that of all unknowns with nothing in the prescribed ones, N/m. Of the contact points on the elements
/// of the node the nearest one is named, of the material points that flow there the one that flows most.
LargestResidual largest_residual(const assembly::Model& model, const assembly::Assembler& assembler,
                                 const assembly::History& history, const VecX& residual);

}  // namespace cleft::solve
