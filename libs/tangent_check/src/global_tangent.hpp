// The assembled matrix against differences of the assembled force.
#pragma once

#include <functional>

#include "cleft/assembly/block_matrix.hpp"
#include "cleft/tangent_check/tangent.hpp"

namespace cleft::tangent_check {

/// The force at some displacement (N/m, all components), and the unknowns on which contact points act that stand on
/// another branch of their law there.
struct GlobalForce {
  VecX force;
  std::vector<Index> kinked;
};
using Evaluate = std::function<GlobalForce(const VecX& u)>;

/// The block that takes the entries of a row of unknowns; null for rows that are not compared.
using BlockOfRow = std::function<TangentBlock*(Index unknown)>;

/// Steps of differences, metres.
struct GlobalSteps {
  std::vector<double> first;  ///< per unknown
  double least = 0.0;         ///< below which rounding shows
};

/// A matrix, and the force whose derivative it should be.
struct MatrixCheck {
  const assembly::BlockMatrix& matrix;
  const VecX& u;  ///< where, metres, all components
  const GlobalSteps& steps;
  Evaluate evaluate;
  BlockOfRow block_of;
  double load = 0.0, tolerance = 0.0;
  VecX least_scale{};  ///< of each row, by which entries are measured if all in it are smaller; empty: none
};

/// Compares all columns, many at a time. A force that changes although none of the moved columns has an entry in its
/// row is an entry that the matrix lacks (with column kNone).
void check_matrix(const MatrixCheck& check);

}  // namespace cleft::tangent_check
