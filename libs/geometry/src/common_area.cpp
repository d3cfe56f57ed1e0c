#include "cleft/geometry/common_area.hpp"

#include <algorithm>

namespace cleft::geometry {
namespace {

// A convex polygon, counter-clockwise. Each of three lines adds a corner, or, were rounding to make it wavy, half as
// many again.
struct ConvexPolygon {
  std::array<Vec2, 9> corner;
  std::size_t count = 0;

  void add(const Vec2& point) { corner[count++] = point; }

  double area() const {
    double twice = 0.0;
    for (std::size_t k = 2; k < count; ++k) twice += cross(corner[k - 1] - corner[0], corner[k] - corner[0]);
    return 0.5 * twice;
  }
};

ConvexPolygon convex_polygon(const std::array<Vec2, 3>& triangle) {
  return {{triangle[0], triangle[1], triangle[2]}, 3};
}

// What lies left of the line from p to q (Sutherland and Hodgman 1974, Commun. ACM 17, 32-42).
ConvexPolygon left_of(const Vec2& p, const Vec2& q, const ConvexPolygon& all) {
  ConvexPolygon out;
  for (std::size_t k = 0; k < all.count; ++k) {
    const Vec2 &a = all.corner[k], &b = all.corner[(k + 1) % all.count];
    const double from = cross(q - p, a - p), to = cross(q - p, b - p);
    if (from >= 0.0) out.add(a);
    if ((from > 0.0 && to < 0.0) || (from < 0.0 && to > 0.0)) out.add(a + from / (from - to) * (b - a));
  }
  return out;
}

}  // namespace

double common_area(const std::array<Vec2, 3>& a, const std::array<Vec2, 3>& b) {
  if (!(convex_polygon(b).area() > 0.0)) return 0.0;
  ConvexPolygon common = convex_polygon(a);
  for (std::size_t k = 0; k < 3; ++k) common = left_of(b[k], b[(k + 1) % 3], common);
  return std::max(common.area(), 0.0);
}

}  // namespace cleft::geometry
