// The coordinates in which a scene is discretised.
#pragma once

#include <array>

#include "cleft/scene/description.hpp"

namespace cleft::scene {

/// Where the coordinates of a body in the box from `low` to `high` begin, metres: at the scene's origin if that is
/// within a few extents of the body, else near the lower left corner. Coordinates of the body less this are exact.
Vec2 local_origin(const Vec2& low, const Vec2& high);

/// A scene whose places (mesh, cracks, boxes, centres of rotation) count from `origin`. Affine displacements and fields
/// are not places but functions of the scene's coordinates; who evaluates them adds the origin.
struct LocalScene {
  Vec2 origin = Vec2::Zero();
  Scene scene;
};
LocalScene relative_to(const Vec2& origin, Scene scene);

}  // namespace cleft::scene
