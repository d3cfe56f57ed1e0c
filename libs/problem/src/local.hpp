// The coordinates in which a scene is discretised.
#pragma once

#include "cleft/problem/specification.hpp"

namespace cleft::problem {

/// Where the coordinates of a body in the box from `low` to `high` begin, metres: at the scene's origin if that is
/// within a few extents of the body, else near the lower left corner.
Vec2 local_origin(const Vec2& low, const Vec2& high);

/// A place of the scene as it counts from `origin`. Decimal coordinates stay what is written: 466002.3 becomes 2.3.
Vec2 count_from(const Vec2& origin, const Vec2& place);

/// A scene whose places (mesh, cracks, boxes, centres of rotation) count from `origin`. Affine displacements and fields
/// are not places but functions of the scene's coordinates; who evaluates them adds the origin.
struct LocalSpecification {
  Vec2 origin = Vec2::Zero();
  Specification specification;
};
LocalSpecification relative_to(const Vec2& origin, Specification specification);

}  // namespace cleft::problem
