/// \file
/// How large the elements of an unstructured mesh may be, place by place.
#pragma once

#include <vector>

#include "cleft/support/types.hpp"

namespace cleft::geometry {

/// Elements of at most `size` along a polyline, or at a single point.
struct SizeSource {
  std::vector<Vec2> line;  ///< metres, at least one point
  double size = 0.0;       ///< metres
};

/// The longest edge that an element may have, metres: `far` away from all sources; at a distance d from a source at
/// most its size + gradation d.
struct SizeField {
  double far = 0.0;
  double gradation = 0.25;
  std::vector<SizeSource> sources;

  double operator()(const Vec2& place) const;
};

}  // namespace cleft::geometry
