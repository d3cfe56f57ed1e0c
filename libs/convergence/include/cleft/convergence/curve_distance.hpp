/// \file
/// Distances between two curves along a crack.
#pragma once

#include <array>
#include <optional>
#include <vector>

namespace cleft::convergence {

/// Values over an abscissa, any order. Points whose value is not finite do not count.
struct Curve {
  std::vector<double> place, value;
};

/// The interval on which both are given.
std::optional<std::array<double, 2>> common_range(const Curve& a, const Curve& b);

struct CurveDistance {
  double l2 = 0.0;  ///< sqrt of the integral of (a - b)^2, in the value's unit times the root of the abscissa's
  double l2_relative = 0.0;       ///< over the norm of b
  double largest = 0.0;           ///< largest |a - b|
  double largest_relative = 0.0;  ///< over the largest |b|
};

/// Distance on an interval, both taken piecewise linear between their points and constant beyond their ends. The
/// integrals are exact. Throws std::invalid_argument where a curve has no point or the interval is empty.
CurveDistance distance(const Curve& a, const Curve& b, const std::array<double, 2>& range);

}  // namespace cleft::convergence
