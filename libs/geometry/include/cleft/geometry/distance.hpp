/// \file
/// Distances in the plane.
#pragma once

#include <algorithm>

#include "cleft/support/types.hpp"

namespace cleft::geometry {

/// Of a point from the segment from `a` to `b`, in their unit.
inline double distance_to_segment(const Vec2& a, const Vec2& b, const Vec2& point) {
  const Vec2 along = b - a;
  const double fraction = std::clamp((point - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (point - a - fraction * along).norm();
}

}  // namespace cleft::geometry
