/// \file
/// Where the lines of structured meshes lie along an axis.
#pragma once

#include <array>
#include <vector>

namespace cleft::geometry {

/// `cells` equal intervals from `from` to `to`: their ends, ascending, cells + 1 of them. Same unit as the input.
std::vector<double> even_lines(double from, double to, int cells);

/// Part of an axis that gets small intervals.
struct Focus {
  double from = 0.0, to = 0.0;
  double share = 0.0;  ///< of all intervals, between 0 and 1
};

/// Equal intervals in the focus, as many as its share says, and outside of it intervals that grow by the same factor
/// from each to the next, counted from the focus. The ends of the focus are lines. `cells` + 1 places, ascending.
/// Throws InputError (key `share`) where the intervals outside would be smaller than those in the focus, or too few.
std::vector<double> graded_lines(double from, double to, int cells, const Focus& focus);

}  // namespace cleft::geometry
