// Why an iteration cannot go on.
#pragma once

#include "cleft/assembly/failure.hpp"
#include "cleft/solve/linear_solver.hpp"
#include "cleft/solve/newton.hpp"

namespace cleft::solve {

/// The largest component of a vector.
struct Extreme {
  Index component = kNone;
  double size = 0.0;  ///< without sign
};
Extreme largest(const VecX& values);

/// No convergence: the last iterate, after so many iterations of which so many were halved, with its residual.
assembly::Failure unbalanced(const assembly::Model& model, const Iteration& last, int iterations, const VecX& residual,
                             int halved);

/// Of factors that lead to no correction, or to one that is farther than anything can move; `correction` is empty
/// without factors.
assembly::Failure useless(const assembly::Model& model, Factors factors, const VecX& correction);

/// A part that nothing but contact holds has left, correction by correction.
assembly::Failure left_behind(const assembly::Model& model, const VecX& moved);

}  // namespace cleft::solve
