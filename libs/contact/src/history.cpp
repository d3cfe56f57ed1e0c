#include "cleft/contact/history.hpp"

#include <cmath>

#include "cleft/contact/undeformed.hpp"
#include "friction_work.hpp"

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

// theory (7.3): where the tangential gap is `target`.
Place anchor_at(const Surfaces& surfaces, const FacePositions& at, Index p, const Pair& pair, double target) {
  if (surfaces.undeformed) return {pair.partner_face, anchor_place_at(surfaces, at, p, target)};
  const Point& point = surfaces.points[p];
  const Vec2 along = at.end[point.face] - at.start[point.face];
  const Vec2 y = at.start[point.face] + point.eta * along;
  return walk(surfaces, at, pair.partner_face, y, along.normalized(), target);
}

// Where a point without an anchor takes hold: without tangential gap.
void take_hold(const Surfaces& surfaces, const FacePositions& at, Index p, const Pair& pair, ContactState& past) {
  past.anchor_face = pair.partner_face;
  past.anchor_place = surfaces.undeformed ? anchor_place_at(surfaces, at, p, 0.0) : pair.state.partner;
}

double mean(double a, double b) { return 0.5 * (a + b); }

// The part of the increment over which the point presses if its normal gap changes evenly.
double pressed_part(const Springs& springs, const PairState& now, const ContactState& past) {
  if (now.traction.status != Status::Open) return 1.0;
  const double pull = springs.normal * std::fmax(0.0, now.normal_gap);
  return pull > past.normal ? past.normal / (past.normal - pull) : 0.0;
}

// Per unit of the ramp. What the springs would bear without sliding goes beyond the strength by what the slide takes
// off.
double friction_work(const InterfaceLaw& law, const Springs& springs, const PairState& now, const ContactState& past) {
  if (now.traction.status == Status::Stick) return 0.0;
  const double pressed = pressed_part(springs, now, past);
  const double trial = past.tangential + pressed * (springs.tangential * now.tangential_gap - past.tangential);
  const double at_end = std::fabs(now.traction.tangential);
  return friction_of({std::copysign(1.0, trial) * past.tangential, strength(law, -past.normal, past.state).value,
                      at_end, springs.tangential, std::fmax(0.0, std::fabs(trial) - at_end) / springs.tangential});
}

// From the point to the material point that is its partner now.
Vec2 to_partner(const FacePositions& at, const Point& point, const Pair& pair) {
  const Index own = point.face, other = pair.partner_face;
  const double xi = pair.state.partner;
  return (1.0 - xi) * at.start[other] + xi * at.end[other] -
         ((1.0 - point.eta) * at.start[own] + point.eta * at.end[own]);
}

}  // namespace

double touching_friction(const Surfaces& surfaces, const FacePositions& before, const FacePositions& at, Index p,
                         const Pair& pair, const ContactState& past) {
  const Point& point = surfaces.points[p];
  const auto& face = surfaces.faces[point.face];
  const Vec2 along = surfaces.undeformed ? Vec2(face.reference_end - face.reference_start)
                                         : Vec2(at.end[point.face] - at.start[point.face]);
  const double slide = (to_partner(at, point, pair) - to_partner(before, point, pair)).dot(along.normalized());
  const Strength limit = strength(surfaces.laws[face.crack], std::fabs(pair.state.traction.normal), past.state);
  return pair.state.ramp * touching_friction_of(limit.value, std::fabs(slide));
}

// theory (7.7)
CommittedPoint commit(const Surfaces& surfaces, const FacePositions& at, Index p, const Pair& pair,
                      const ContactState& past) {
  const Point& point = surfaces.points[p];
  const Index crack = surfaces.faces[point.face].crack;
  const Springs& springs = surfaces.springs[crack];
  const PairState& now = pair.state;
  const double tn = now.traction.normal, tt = now.traction.tangential;

  if (pair.partner_face == kNone || now.ramp == 0.0) {
    ContactState gone;
    gone.state = past.state;
    gone.ramp = 0.0;
    return {gone, 0.0, past.ramp * springs.stored_energy(past.normal, past.tangential)};
  }
  ContactState next = past;
  next.normal = tn;
  next.tangential = tt;
  next.ramp = now.ramp;
  next.slope = now.slope;
  CommittedPoint out{next};
  out.pressure =
      mean(springs.stored_energy(tn, tt), springs.stored_energy(past.normal, past.tangential)) * (past.ramp - now.ramp);
  if (pair.anchored) {
    const double slide = now.tangential_gap - past.tangential / springs.tangential;
    out.pressure += mean(now.ramp * tn * now.slope, past.ramp * past.normal * past.slope) *
                    pressed_part(springs, now, past) * slide;
    out.friction = mean(past.ramp, now.ramp) * friction_work(surfaces.laws[crack], springs, now, past);
  }
  if (now.traction.status == Status::Open) {
    out.end.anchor_face = kNone;
    out.end.anchor_place = 0.0;
  } else if (!pair.anchored) {
    take_hold(surfaces, at, p, pair, out.end);
  } else if (now.traction.status == Status::Slip) {
    const Place anchor = anchor_at(surfaces, at, p, pair, tt / springs.tangential);
    out.end.anchor_face = anchor.face;
    out.end.anchor_place = anchor.place;
    out.end.state = response(surfaces, p, pair, past).end;
  }
  return out;
}

ContactState follow(const Surfaces& surfaces, const FacePositions& at, Index p, const Pair& pair,
                    const ContactState& past) {
  const PairState& now = pair.state;
  ContactState next;
  next.state = past.state;
  next.ramp = pair.partner_face == kNone ? 0.0 : now.ramp;
  if (!presses(pair)) return next;
  if (pair.anchored && now.traction.status == Status::Slip) next.state.slip += std::fabs(now.tangential_gap);
  take_hold(surfaces, at, p, pair, next);
  next.normal = now.traction.normal;
  next.tangential = now.traction.tangential;
  next.slope = now.slope;
  return next;
}

}  // namespace cleft::contact
