#include "cleft/geometry/crack.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cleft::geometry {

std::vector<Vec2> sine_curve(const Vec2& start, const Vec2& end, double amplitude, double periods, double tolerance) {
  const Vec2 along = end - start;
  const Vec2 left = turn_left(along).normalized();
  const double wave_number = 2.0 * std::numbers::pi * periods / along.norm();
  // A chord over a piece dx of a curve with curvature c is within c dx^2 / 8 of it; c <= amplitude * wave_number^2.
  const double curvature = std::fabs(amplitude) * wave_number * wave_number;
  const double quarters = std::max(1.0, 4.0 * periods);
  const double quarter = along.norm() / quarters;
  const double piece = curvature > 0.0 ? std::sqrt(8.0 * tolerance / curvature) : quarter;
  const int per_quarter = std::max(1, static_cast<int>(std::ceil(quarter / piece)));
  const int count = static_cast<int>(std::ceil(quarters * per_quarter - 1e-9));
  std::vector<Vec2> points;
  for (int k = 0; k <= count; ++k) {
    const double x = std::min(1.0, k / (quarters * per_quarter));
    points.push_back(start + x * along + amplitude * std::sin(2.0 * std::numbers::pi * periods * x) * left);
  }
  return points;
}

}  // namespace cleft::geometry
