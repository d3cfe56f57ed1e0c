#include "cleft/geometry/disc.hpp"

#include <algorithm>
#include <cmath>

namespace cleft::geometry {
namespace {

double sector(double radius, const Vec2& a, const Vec2& b) {
  return 0.5 * radius * radius * std::atan2(cross(a, b), a.dot(b));
}

// Signed area of the triangle from the centre (0, 0) over the edge from p to q, as far as it lies within the circle:
// a triangle over the chord that the circle cuts from the edge, and sectors beside it.
double area_over_edge(double radius, const Vec2& p, const Vec2& q) {
  const Vec2 d = q - p;
  const double length = d.squaredNorm();
  if (length == 0.0) return 0.0;
  const double nearest = -p.dot(d) / length, away = cross(p, d);
  const double half = (radius * radius - away * away / length) / length;
  if (half <= 0.0) return sector(radius, p, q);
  const double from = std::clamp(nearest - std::sqrt(half), 0.0, 1.0),
               to = std::clamp(nearest + std::sqrt(half), 0.0, 1.0);
  if (from >= to) return sector(radius, p, q);
  const Vec2 a = p + from * d, b = p + to * d;
  return (from > 0.0 ? sector(radius, p, a) : 0.0) + 0.5 * cross(a, b) + (to < 1.0 ? sector(radius, b, q) : 0.0);
}

}  // namespace

double area_within(const Disc& disc, const std::array<Vec2, 3>& triangle) {
  double area = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
    area += area_over_edge(disc.radius, triangle[k] - disc.centre, triangle[(k + 1) % 3] - disc.centre);
  const double rounding = 1e-14 * disc.radius * disc.radius;  // of the angles, which add up to none for one outside
  return area > rounding ? area : 0.0;
}

}  // namespace cleft::geometry
