/// \file
/// Parts of triangles within a disc.
#pragma once

#include <array>

#include "cleft/support/types.hpp"

namespace cleft::geometry {

struct Disc {
  Vec2 centre;
  double radius = 0.0;  ///< metres
};

/// Area of the part of a triangle that lies within a disc, m^2; the corners counter-clockwise. Exact but for rounding.
double area_within(const Disc& disc, const std::array<Vec2, 3>& triangle);

}  // namespace cleft::geometry
