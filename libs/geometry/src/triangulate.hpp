/// \file
/// Triangles of a small simple polygon.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "cleft/support/types.hpp"

namespace cleft::geometry {

/// Twice the signed area of a closed polygon, m^2, positive for counter-clockwise; exactly 0 if all corners are on two
/// points.
double twice_polygon_area(std::span<const Vec2> polygon);

/// Appends counter-clockwise triangles that fill a counter-clockwise polygon. It may be non-convex and may touch itself
/// at corners. Triangles of at most `negligible` m^2 are left out.
void triangulate(std::vector<Vec2> polygon, double negligible, std::vector<std::array<Vec2, 3>>& triangles);

}  // namespace cleft::geometry
