/// \file
/// Checks of cracks that need no mesh.
#pragma once

#include <vector>

#include "cleft/geometry/crack.hpp"

namespace cleft::geometry {

/// Throws InputError where a crack has fewer than two points, coincident consecutive points or points that are not
/// finite, and where cracks cross or touch themselves or each other. O(points) where points are spread along the
/// cracks.
void check_cracks(const std::vector<Crack>& cracks);

}  // namespace cleft::geometry
