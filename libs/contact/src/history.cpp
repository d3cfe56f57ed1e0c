#include "cleft/contact/history.hpp"

#include <cmath>

namespace cleft::contact {
namespace {

struct Place {
  Index face;
  double place;
};

// The point of the positive face, searched from `from` along its neighbours, at the distance `target` along t from y.
// Beyond the ends of the face its last segment counts as continued.
Place walk(const Surfaces& surfaces, const FacePositions& at, Index from, const Vec2& y, const Vec2& t, double target) {
  Index f = from;
  for (int step = 0;; ++step) {
    const Vec2 e = at.end[f] - at.start[f];
    const double place = (target - (at.start[f] - y).dot(t)) / e.dot(t);
    const Index go = place < 0.0 ? surfaces.faces[f].previous : place > 1.0 ? surfaces.faces[f].next : kNone;
    const bool forward = go != kNone && (at.end[go] - at.start[go]).dot(t) * e.dot(t) > 0.0;
    if (!forward || step > static_cast<int>(surfaces.faces.size())) return {f, place};
    // between two segments that both disown the point (rounding at their vertex) either will do
    const Vec2 next = at.end[go] - at.start[go];
    const double there = (target - (at.start[go] - y).dot(t)) / next.dot(t);
    if ((place < 0.0 && there > 1.0) || (place > 1.0 && there < 0.0)) return {go, place < 0.0 ? 1.0 : 0.0};
    f = go;
  }
}

}  // namespace

Advance advance(const Surfaces& surfaces, const FacePositions& at, Index p, const Pair& pair, const Memory& memory) {
  const Traction& traction = pair.state.traction;
  if (pair.partner_face == kNone || traction.status == Status::Open) return {{kNone, 0.0, memory.slip, 0.0}, 0.0};
  if (memory.anchor_face == kNone) return {{pair.partner_face, pair.state.partner, memory.slip, 0.0}, 0.0};
  if (traction.status == Status::Stick) {
    Memory kept = memory;
    kept.tangential = traction.tangential;
    return {kept, 0.0};
  }
  const Point& point = surfaces.points[p];
  const Law& law = surfaces.laws[surfaces.faces[point.face].crack];
  const Vec2 along = at.end[point.face] - at.start[point.face];
  const Vec2 y = at.start[point.face] + point.eta * along;
  const double target = traction.tangential / law.tangential_penalty;
  const Place anchor = walk(surfaces, at, pair.partner_face, y, along.normalized(), target);
  const double moved = target - pair.state.tangential_gap;
  // While the point slides on in one sense its traction goes over from the last value to this one; after a reversal it
  // unloads elastically first.
  const bool onward = memory.tangential * traction.tangential >= 0.0;
  const double mean = onward ? 0.5 * (memory.tangential + traction.tangential) : traction.tangential;
  return {{anchor.face, anchor.place, memory.slip + std::fabs(moved), traction.tangential}, std::fabs(mean * moved)};
}

}  // namespace cleft::contact
