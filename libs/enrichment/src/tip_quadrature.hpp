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

/// Appends points in a triangle for integrands that go with r^-1, r the distance from `tip`, which may lie anywhere.
void place_points(const Corners& triangle, const Vec2& tip, int refinement, std::vector<QuadraturePoint>& points);

}  // namespace cleft::enrichment
