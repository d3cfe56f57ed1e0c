// Quadrature of functions that are singular at a tip.
#pragma once

#include <array>
#include <vector>

#include "cleft/support/types.hpp"

namespace cleft::enrichment {

struct QuadraturePoint {
  Vec2 place;
  double weight;  // m^2
};

using Corners = std::array<Vec2, 3>;  // counter-clockwise

enum class Rule { Quadratic, Smooth, Polar };

struct QuadratureTriangle {
  Corners corners;  // Polar: the tip first
  Rule rule;
};

/// Appends the triangles into which one is divided for integrands that go with r^-1, r the distance from `tip`, which
/// may lie anywhere. With `refinement` it is first divided into 4^refinement.
void divide(const Corners& triangle, const Vec2& tip, int refinement, std::vector<QuadratureTriangle>& out);

/// Appends the points of one of them.
void place_points(const QuadratureTriangle& triangle, std::vector<QuadraturePoint>& points);

/// Appends the points of all of them, one after the other.
void place_points(const Corners& triangle, const Vec2& tip, int refinement, std::vector<QuadraturePoint>& points);

}  // namespace cleft::enrichment
