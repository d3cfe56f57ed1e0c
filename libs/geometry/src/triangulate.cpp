#include "triangulate.hpp"

#include <cmath>

namespace cleft::geometry {

double twice_polygon_area(std::span<const Vec2> polygon) {
  double sum = 0.0;
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k)
    sum += cross(polygon[k] - polygon[0], polygon[k + 1] - polygon[0]);
  return sum;
}

namespace {

class EarClipper {
 public:
  EarClipper(std::vector<Vec2> polygon, double negligible)
      : polygon_(std::move(polygon)), negligible_(2.0 * negligible) {}

  void run(std::vector<std::array<Vec2, 3>>& triangles) {
    while (polygon_.size() >= 3) {
      const std::size_t k = next();
      if (twice_area(k) > negligible_) triangles.push_back({before(k), polygon_[k], after(k)});
      polygon_.erase(polygon_.begin() + static_cast<std::ptrdiff_t>(k));
    }
  }

 private:
  const Vec2& before(std::size_t k) const { return polygon_[k == 0 ? polygon_.size() - 1 : k - 1]; }
  const Vec2& after(std::size_t k) const { return polygon_[k + 1 == polygon_.size() ? 0 : k + 1]; }
  double twice_area(std::size_t k) const { return cross(polygon_[k] - before(k), after(k) - before(k)); }

  bool is_ear(std::size_t k, double slack) const {
    const Vec2 &a = before(k), &b = polygon_[k], &c = after(k);
    for (const Vec2& p : polygon_) {
      if (p == a || p == b || p == c) continue;
      if (cross(b - a, p - a) >= -slack && cross(c - b, p - b) >= -slack && cross(a - c, p - c) >= -slack) return false;
    }
    return true;
  }

  std::size_t largest_ear(double slack) const {
    std::size_t ear = polygon_.size();
    for (std::size_t k = 0; k < polygon_.size(); ++k) {
      const double area = twice_area(k);
      if (area > 0.0 && (ear == polygon_.size() || area > twice_area(ear)) && is_ear(k, slack)) ear = k;
    }
    return ear;
  }

  // Corners on a straight line go first: they take no area with them. Corners that touch an ear within rounding forbid
  // it if there is another. Rounding may leave a polygon without any ear, then the most convex corner is as good as
  // any.
  std::size_t next() const {
    std::size_t convex = 0;
    for (std::size_t k = 0; k < polygon_.size(); ++k) {
      const double area = twice_area(k);
      if (std::abs(area) <= negligible_) return k;
      if (area > twice_area(convex)) convex = k;
    }
    for (const double slack : {1e4 * negligible_, 0.0}) {
      if (const std::size_t ear = largest_ear(slack); ear < polygon_.size()) return ear;
    }
    return convex;
  }

  std::vector<Vec2> polygon_;
  double negligible_;
};

}  // namespace

void triangulate(std::vector<Vec2> polygon, double negligible, std::vector<std::array<Vec2, 3>>& triangles) {
  // Where the polygon touches itself at a corner it is two polygons.
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    for (std::size_t j = i + 1; j < polygon.size(); ++j) {
      if (polygon[i] != polygon[j]) continue;
      const auto first = polygon.begin() + static_cast<std::ptrdiff_t>(i),
                 last = polygon.begin() + static_cast<std::ptrdiff_t>(j);
      triangulate({first, last}, negligible, triangles);
      polygon.erase(first, last);
      triangulate(std::move(polygon), negligible, triangles);
      return;
    }
  }
  EarClipper(std::move(polygon), negligible).run(triangles);
}

}  // namespace cleft::geometry
