/// \file
/// What happened on the way of a run that its reader should know.
#pragma once

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

/// Where the path turns, or where the determinant changes its sign and another one may branch off.
struct CriticalPoint {
  enum class Kind { Maximum, Minimum, Bifurcation } kind;
  double load = 0.0;    ///< of the increment nearest to a limit point, or of the first beyond a bifurcation
  double before = 0.0;  ///< of the one before that
  long step = 0;        ///< its row of history.csv
};

}  // namespace cleft::results
