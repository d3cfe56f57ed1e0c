/// \file
/// What two triangles have in common.
#pragma once

#include <array>

#include "cleft/support/types.hpp"

namespace cleft::geometry {

/// Area that lies in both triangles, m^2; the corners of both counter-clockwise. Exact but for rounding, of the square
/// of their size: triangles that only touch may have that much in common. Not negative.
double common_area(const std::array<Vec2, 3>& a, const std::array<Vec2, 3>& b);

}  // namespace cleft::geometry
