/// \file
/// What the increments of a run have cost, and what happened on the way that its reader should know.
#pragma once

#include <vector>

#include "cleft/growth/evolution.hpp"

namespace cleft::results {

/// Increments whose iteration was ended by rounding, at a residual above solve::kUnnoticedResidual.
struct Rounded {
  long increments = 0;
  double worst = 0.0;  ///< residual over the largest force of the run so far,
  double load = 0.0;   ///< and where that was
};

/// Increments that seem to have jumped from one branch of solutions to another (solve::Step::jumped).
struct Jumps {
  long increments = 0;
  double load = 0.0;  ///< of the first
};

/// Sums over the increments of a run, those of its earlier parts included.
struct Counts {
  long increments = 0, iterations = 0, cuts = 0;
  double worst_residual = 0.0;
  Rounded rounded;
  Jumps jumps;
  /// Of convergence, of each increment that shows one; of this part of the run only.
  std::vector<double> orders;

  void count(const growth::Step& step);
  /// 0 where no increment shows an order.
  double median_order() const;
};

}  // namespace cleft::results
