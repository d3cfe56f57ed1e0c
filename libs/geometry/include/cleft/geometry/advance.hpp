/// \file
/// Cracks that get longer.
#pragma once

#include "cleft/geometry/crack.hpp"
#include "cleft/geometry/mesh.hpp"

namespace cleft::geometry {

/// How far a segment that starts inside a body gets: where it leaves the body first, or its end; metres.
Vec2 reach(const Mesh& mesh, const Vec2& from, const Vec2& to);

/// The crack with one more point at its first (0) or last (1) end. Arc lengths of the old points stay.
Crack extended(Crack crack, int end, const Vec2& point);

/// One end of a crack as it is drawn: its first (0) or last (1) point, and the unit vector that leads on from there.
struct Tip {
  Vec2 point;
  Vec2 ahead;
};
Tip tip_of(const Crack& crack, int end);

}  // namespace cleft::geometry
