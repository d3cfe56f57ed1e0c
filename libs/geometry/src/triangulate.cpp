#include "triangulate.hpp"

#include <cmath>

namespace cleft::geometry {

double twice_polygon_area(std::span<const Vec2> polygon) {
  double sum = 0.0;
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k) sum += cross(polygon[k] - polygon[0], polygon[k + 1] - polygon[0]);
  return sum;
}

namespace {

class EarClipper {
 public:
  EarClipper(std::vector<Vec2> polygon, double negligible) : polygon_(std::move(polygon)), negligible_(2.0 * negligible) {}

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

  bool is_ear(std::size_t k) const {
    const Vec2 &a = before(k), &b = polygon_[k], &c = after(k);
    for (const Vec2& p : polygon_) {
      if (p == a || p == b || p == c) continue;
      if (cross(b - a, p - a) >= 0.0 && cross(c - b, p - b) >= 0.0 && cross(a - c, p - c) >= 0.0) return false;
    }
    return true;
  }

  // Corners on a straight line go first: they take no area with them. Among ears the largest is taken. Rounding may leave a
  // polygon without any ear, then the most convex corner is as good as any.
  std::size_t next() const {
    std::size_t ear = polygon_.size(), convex = 0;
    for (std::size_t k = 0; k < polygon_.size(); ++k) {
      const double area = twice_area(k);
      if (std::abs(area) <= negligible_) return k;
      if (area > twice_area(convex)) convex = k;
      if (area > 0.0 && (ear == polygon_.size() || area > twice_area(ear)) && is_ear(k)) ear = k;
    }
    return ear < polygon_.size() ? ear : convex;
  }

  std::vector<Vec2> polygon_;
  double negligible_;
};

}  // namespace

void triangulate(std::vector<Vec2> polygon, double negligible, std::vector<std::array<Vec2, 3>>& triangles) {
  EarClipper(std::move(polygon), negligible).run(triangles);
}

}  // namespace cleft::geometry
