#include "tip_quadrature.hpp"

#include <algorithm>
#include <cmath>

#include "cleft/geometry/distance.hpp"

namespace cleft::enrichment {

namespace {

using Points = std::vector<QuadraturePoint>;
using Triangles = std::vector<QuadratureTriangle>;

// A triangle may be this much larger than its distance from the tip.
constexpr double kLargest = 1.0;
// Where it is this much smaller, the functions are nearly quadratic in it.
constexpr double kSmall = 1.0 / 3.0;
// A tip within this part of a triangle's size from an edge or corner is on it.
constexpr double kOnEdge = 1e-10;
// Bisections after which a triangle is negligible, whatever the tip's distance.
constexpr int kDeepest = 32;

double twice_area(const Corners& t) { return cross(t[1] - t[0], t[2] - t[0]); }

double size_of(const Corners& t) {
  return std::max({(t[1] - t[0]).norm(), (t[2] - t[1]).norm(), (t[0] - t[2]).norm()});
}

std::array<Corners, 4> quarters(const Corners& t) {
  const Vec2 ab = 0.5 * (t[0] + t[1]), bc = 0.5 * (t[1] + t[2]), ca = 0.5 * (t[2] + t[0]);
  return {Corners{t[0], ab, ca}, Corners{ab, t[1], bc}, Corners{ca, bc, t[2]}, Corners{ab, bc, ca}};
}

// The longest edge is halved, which turns needles into well-shaped triangles on the way.
std::array<Corners, 2> halves(const Corners& t) {
  int k = 0;
  for (const int other : {1, 2})
    if ((t[(other + 1) % 3] - t[other]).norm() > (t[(k + 1) % 3] - t[k]).norm()) k = other;
  const Vec2 &a = t[k], &b = t[(k + 1) % 3], &c = t[(k + 2) % 3];
  const Vec2 middle = 0.5 * (a + b);
  return {Corners{a, middle, c}, Corners{middle, b, c}};
}

// Radon's seven points, exact to degree 5.
void place_smooth(const Corners& t, Points& points) {
  const double area = 0.5 * twice_area(t), root = std::sqrt(15.0);
  points.push_back({(t[0] + t[1] + t[2]) / 3.0, 9.0 / 40.0 * area});
  for (const double sign : {-1.0, 1.0}) {
    const double a = (6.0 + sign * root) / 21.0, w = (155.0 + sign * root) / 1200.0 * area;
    for (int k = 0; k < 3; ++k) points.push_back({a * (t[0] + t[1] + t[2]) + (1.0 - 3.0 * a) * t[k], w});
  }
}

// Three points, exact to degree 2: less than half the points of a large ball, at no loss that would be seen.
void place_quadratic(const Corners& t, Points& points) {
  for (int k = 0; k < 3; ++k) points.push_back({(t[0] + t[1] + t[2]) / 6.0 + 0.5 * t[k], twice_area(t) / 6.0});
}

struct GaussPoint {
  double place, weight;  // on (0, 1)
};
constexpr std::array<GaussPoint, 5> kGauss{{{0.046910077030668, 0.1184634425280945},
                                            {0.2307653449471585, 0.2393143352496832},
                                            {0.5, 0.2844444444444444},
                                            {0.7692346550528415, 0.2393143352496832},
                                            {0.953089922969332, 0.1184634425280945}}};

// theory (2.8). The tip is corner 0: x = tip + r [(1 - s) (a - tip) + s (b - tip)], dA = 2 Area r dr ds. With r = p^2
// the integrand, r^(-1), r^(-1/2), 1 ... times r, is a polynomial of p. In s it is smooth where a-b is seen under no
// large angle.
void place_polar(const Corners& t, Points& points) {
  const Vec2 &tip = t[0], &a = t[1], &b = t[2];
  const double twice = twice_area(t);
  for (const auto& [p, wp] : kGauss) {
    for (const auto& [s, ws] : kGauss) {
      const double r = p * p;
      points.push_back({tip + r * ((1.0 - s) * (a - tip) + s * (b - tip)), twice * r * 2.0 * p * wp * ws});
    }
  }
}

// Until the edge that faces the tip, corner 0, is seen under no large angle.
void divide_polar(const Corners& t, int depth, Triangles& out) {
  const Vec2 &tip = t[0], &a = t[1], &b = t[2];
  if ((b - a).norm() > kLargest * geometry::distance_to_segment(a, b, tip) && depth < kDeepest) {
    const Vec2 middle = 0.5 * (a + b);
    divide_polar({tip, a, middle}, depth + 1, out);
    divide_polar({tip, middle, b}, depth + 1, out);
  } else {
    out.push_back({t, Rule::Polar});
  }
}

void divide_at_depth(int depth, const Corners& t, const Vec2& tip, Triangles& out) {
  const double size = size_of(t), negligible = kOnEdge * size * size;
  std::array<Corners, 3> fan;
  bool inside = true;
  for (int k = 0; k < 3; ++k) {
    fan[k] = {tip, t[k], t[(k + 1) % 3]};
    inside = inside && twice_area(fan[k]) > -negligible;
  }
  if (inside) {
    for (const Corners& part : fan) {
      if (twice_area(part) > negligible) divide_polar(part, 0, out);
    }
    return;
  }
  const double away =
      std::min({geometry::distance_to_segment(t[0], t[1], tip), geometry::distance_to_segment(t[1], t[2], tip),
                geometry::distance_to_segment(t[2], t[0], tip)});
  if (size <= kSmall * away) {
    out.push_back({t, Rule::Quadratic});
  } else if (size <= kLargest * away || depth == kDeepest) {
    out.push_back({t, Rule::Smooth});
  } else {
    for (const Corners& part : halves(t)) divide_at_depth(depth + 1, part, tip, out);
  }
}

}  // namespace

void divide(const Corners& triangle, const Vec2& tip, int refinement, Triangles& out) {
  if (refinement == 0) {
    divide_at_depth(0, triangle, tip, out);
  } else {
    for (const Corners& part : quarters(triangle)) divide(part, tip, refinement - 1, out);
  }
}

void place_points(const QuadratureTriangle& triangle, Points& points) {
  switch (triangle.rule) {
    case Rule::Quadratic:
      return place_quadratic(triangle.corners, points);
    case Rule::Smooth:
      return place_smooth(triangle.corners, points);
    case Rule::Polar:
      return place_polar(triangle.corners, points);
  }
}

void place_points(const Corners& triangle, const Vec2& tip, int refinement, Points& points) {
  Triangles triangles;
  divide(triangle, tip, refinement, triangles);
  for (const QuadratureTriangle& part : triangles) place_points(part, points);
}

}  // namespace cleft::enrichment
