// Exact decisions about positions, on doubles taken as they are.
#pragma once

#include "cleft/support/types.hpp"

namespace cleft::geometry {

/// Sign of the area of the triangle a, b, c: +1 counter-clockwise, -1 clockwise, 0 on one line.
int orientation(const Vec2& a, const Vec2& b, const Vec2& c);

/// Side of `node` seen from the line p -> q translated by an infinitesimal (e, e^2): +1 left, -1 right; never 0 (p and
/// q differ).
int side_of_shifted_line(const Vec2& p, const Vec2& q, const Vec2& node);

/// Side of the point p, translated likewise, seen from the mesh edge a -> b.
int shifted_side_of_edge(const Vec2& a, const Vec2& b, const Vec2& p);

/// Whether two closed segments share a point; touching counts.
bool segments_meet(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d);

/// Whether v-s runs back along p-v, its predecessor.
bool folds_back(const Vec2& p, const Vec2& v, const Vec2& s);

/// The straight line of a crack segment, directed.
struct Line {
  Vec2 start, end;
};

/// Where the line meets the mesh edge a-b: 0 at `a`, 1 at `b`, rounded only once. They may not be parallel.
double crossing_place(const Vec2& a, const Vec2& b, const Line& line);

/// Order in which two crack lines, translated by the infinitesimal (e, e^2), cross the mesh edge a-b: -1 if `first`
/// crosses nearer to `a`, +1 if `second` does, 0 if they cross at one point even so. Neither may be parallel to the
/// edge.
int compare_crossings(const Vec2& a, const Vec2& b, const Line& first, const Line& second);

}  // namespace cleft::geometry
