// The assembled matrix against differences of the assembled force.
#pragma once

#include <functional>

#include "cleft/assembly/block_matrix.hpp"
#include "cleft/tangent_check/tangent.hpp"

namespace cleft::tangent_check {

/// The force at some displacement (N/m, all components), and the unknowns on which contact points act that stand on
/// another branch of their law there.
struct WholeForce {
  VecX force;
  std::vector<Index> kinked;
};
using Evaluate = std::function<WholeForce(const VecX& u)>;

/// The block that takes the entries of a row of unknowns.
using BlockOfRow = std::function<TangentBlock&(Index unknown)>;

/// Compares all columns with steps given per unknown, many columns at a time. A force that changes although none of the
/// moved columns has an entry in its row is an entry that the matrix lacks (with column kNone).
void check_matrix(const assembly::BlockMatrix& matrix, const VecX& u, const std::vector<double>& step,
                  const Evaluate& evaluate, double load, double tolerance, const BlockOfRow& block_of);

}  // namespace cleft::tangent_check
