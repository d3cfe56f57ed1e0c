#include "cleft/contact/search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cleft/contact/undeformed.hpp"

namespace cleft::contact {

namespace {

constexpr double kVertex = 1e-10;  // both neighbours of a vertex are tried, so that none is lost between them
constexpr double kClose = 0.25;    // of an element: most partners are nearer, and few faces have to be looked at there

// The normal line of a point, and how far along it a partner may be.
struct PointRay {
  Vec2 y, t, n;
  double length, reach;
  Index point, crack;
};

struct Hit {
  Index face = kNone;
  double gap = std::numeric_limits<double>::infinity();
};

// A free end of a face.
struct Mouth {
  Index face;
  bool at_end;
};

PointRay ray_of(const Surfaces& surfaces, const FacePositions& at, Index p, double radius) {
  const Point& point = surfaces.points[p];
  const Vec2 along = at.end[point.face] - at.start[point.face];
  const double length = along.norm();
  const Vec2 t = along / length;
  const double sign = surfaces.faces[point.face].normal_sign();
  return {at.start[point.face] + point.eta * along, t, sign * turn_left(t), length, radius, p,
          surfaces.faces[point.face].crack};
}

// theory (6.1): where the ray's line meets the line of a face, if that face looks at the ray.
bool meets(const Surfaces& surfaces, const FacePositions& at, const PointRay& ray, Index f, double& xi, double& gap) {
  const Vec2 e = at.end[f] - at.start[f];
  const double et = e.dot(ray.t);
  if (surfaces.faces[f].normal_sign() * turn_left(e).dot(ray.n) >= 0.0 || et == 0.0) return false;
  xi = (ray.y - at.start[f]).dot(ray.t) / et;
  gap = (at.start[f] + xi * e - ray.y).dot(ray.n);
  // The face of another crack deeper inside than an element is not penetrated but simply behind the body in between.
  if (surfaces.faces[f].crack != ray.crack && gap < -surfaces.element_size) return false;
  return std::fabs(gap) <= ray.reach;
}

// Places of the point's share along its tangent, relative to the point, seen from a free end whose body lies ahead (+1)
// or behind.
double inner_share(const Point& point, double length, int direction) {
  return (direction > 0 ? point.share_end - point.eta : point.eta - point.share_begin) * length;
}
double outer_share(const Point& point, double length, int direction) { return inner_share(point, length, -direction); }

// +1 if the face continues along the ray's tangent from its free end, -1 if against it.
int direction_of(const FacePositions& at, const PointRay& ray, Index f, bool at_end) {
  const bool along = (at.end[f] - at.start[f]).dot(ray.t) > 0.0;
  return along != at_end ? 1 : -1;
}

// Whether `wanted` belongs to the chain of segments that ends freely at the end (or start) of `f`.
bool same_face(const Surfaces& surfaces, Index f, bool at_end, Index wanted) {
  while (f != kNone && f != wanted) f = at_end ? surfaces.faces[f].previous : surfaces.faces[f].next;
  return f != kNone;
}

// What the free end of a face makes of the partner found so far, where the point's share lies across it.
void pass_mouth(const Surfaces& surfaces, const FacePositions& at, const PointRay& ray, const Mouth& mouth, Hit& hit,
                Pair& pair) {
  const Point& point = surfaces.points[ray.point];
  const auto& [f, at_end] = mouth;
  if (!(at_end ? surfaces.faces[f].free_end : surfaces.faces[f].free_start)) return;
  double xi = 0.0, gap = 0.0;
  if (!meets(surfaces, at, ray, f, xi, gap)) return;
  const Vec2& end = at_end ? at.end[f] : at.start[f];
  const int direction = direction_of(at, ray, f, at_end);
  const double overrun = -direction * (ray.y - end).dot(ray.t);
  if (overrun >= inner_share(point, ray.length, direction)) return;   // wholly past the end
  if (-overrun >= outer_share(point, ray.length, direction)) return;  // wholly before it
  const bool beyond = overrun > 0.0;
  if (beyond && (hit.face != kNone && std::fabs(hit.gap) < std::fabs(gap))) return;
  if (beyond) hit = {f, gap};
  // a mouth ends the face that is opposite; behind another one it has no say
  if (!beyond && !same_face(surfaces, f, at_end, hit.face)) return;
  pair.mouth_face = f;
  pair.mouth_at_end = at_end;
}

}  // namespace

void place_faces(const Surfaces& surfaces, const VecX& displacement, FacePositions& out) {
  const auto count = static_cast<Index>(surfaces.faces.size());
  out.start.resize(count);
  out.end.resize(count);
  for (Index f = 0; f < count; ++f) {
    const auto& face = surfaces.faces[f];
    out.start[f] = face.start.displacement(displacement);
    out.end[f] = face.end.displacement(displacement);
    if (surfaces.undeformed) continue;
    out.start[f] += face.reference_start;
    out.end[f] += face.reference_end;
  }
}

void Search::run(const Surfaces& surfaces, const VecX& displacement, const std::vector<ContactState>& past,
                 double deepest, std::vector<Pair>& pairs) {
  place_faces(surfaces, displacement, positions_);
  pairs.resize(surfaces.points.size());
  if (!surfaces.undeformed) return find_nearest(surfaces, past, deepest, pairs);
  for (Index p = 0; p < static_cast<Index>(pairs.size()); ++p) pairs[p] = opposite(surfaces, positions_, p, past[p]);
}

void Search::find_nearest(const Surfaces& surfaces, const std::vector<ContactState>& past, double deepest,
                          std::vector<Pair>& pairs) {
  collect_partners(surfaces);
  const double radius =  // theory (6.2)
      surfaces.search_radius > 0.0 ? surfaces.search_radius : std::max(5.0 * surfaces.element_size, 10.0 * deepest);
  const auto nearest = [&](PointRay ray, double reach) {
    ray.reach = reach;
    Hit hit;
    const Vec2 from = ray.y - reach * ray.n, to = ray.y + reach * ray.n;
    grid_.near(from, to, [&](Index k) {
      double xi = 0.0, gap = 0.0;
      if (!meets(surfaces, positions_, ray, partners_[k], xi, gap)) return;
      if (xi < -kVertex || xi > 1.0 + kVertex) return;
      if (std::fabs(gap) < std::fabs(hit.gap)) hit = {partners_[k], gap};
    });
    return hit;
  };
  for (Index p = 0; p < static_cast<Index>(pairs.size()); ++p) {
    Pair& pair = pairs[p];
    pair = Pair{};
    const PointRay ray = ray_of(surfaces, positions_, p, radius);
    if (!(ray.length > 0.0)) continue;
    Hit hit = nearest(ray, std::min(kClose * surfaces.element_size, radius));
    if (hit.face == kNone) hit = nearest(ray, radius);
    for (const Index f : mouths_)
      for (const bool at_end : {false, true}) pass_mouth(surfaces, positions_, ray, {f, at_end}, hit, pair);
    if (hit.face == kNone) {
      pair = Pair{};
      continue;
    }
    pair.partner_face = hit.face;
    pair.anchored = holds_on(surfaces, past[p], hit.face);
    pair.state = evaluate(pair_points(surfaces, positions_, p, pair, past[p]),
                          pair_constants(surfaces, positions_, p, pair, past[p]));
  }
}

void Search::collect_partners(const Surfaces& surfaces) {
  partners_.clear();
  mouths_.clear();
  partner_start_.clear();
  partner_end_.clear();
  for (Index f = 0; f < static_cast<Index>(surfaces.faces.size()); ++f) {
    const auto& face = surfaces.faces[f];
    if (!surfaces.is_partner(face)) continue;
    partners_.push_back(f);
    partner_start_.push_back(positions_.start[f]);
    partner_end_.push_back(positions_.end[f]);
    if (face.free_start || face.free_end) mouths_.push_back(f);
  }
  grid_.build(partner_start_, partner_end_);
}

ContactResponse response(const Surfaces& surfaces, Index p, const Pair& pair, const ContactState& past) {
  const Index crack = surfaces.faces[surfaces.points[p].face].crack;
  return respond(surfaces.laws[crack], surfaces.springs[crack],
                 {pair.state.normal_gap, pair.state.tangential_gap, pair.anchored}, surfaces.touch(), past.state);
}

PairPoints pair_points(const Surfaces& surfaces, const FacePositions& at, Index p, const Pair& pair,
                       const ContactState& past) {
  const Index own = surfaces.points[p].face;
  PairPoints out{at.start[own], at.end[own], at.start[pair.partner_face], at.end[pair.partner_face],
                 Vec2::Zero(),  Vec2::Zero()};
  if (const Index a = past.anchor_face; a != kNone)
    out.anchor = (1.0 - past.anchor_place) * at.start[a] + past.anchor_place * at.end[a];
  if (const Index m = pair.mouth_face; m != kNone) out.mouth = pair.mouth_at_end ? at.end[m] : at.start[m];
  return out;
}

PairConstants pair_constants(const Surfaces& surfaces, const FacePositions& at, Index p, const Pair& pair,
                             const ContactState& past) {
  const Point& point = surfaces.points[p];
  const auto& face = surfaces.faces[point.face];
  PairConstants out{.law = surfaces.laws[face.crack],
                    .springs = surfaces.springs[face.crack],
                    .begin = past.state,
                    .touch = surfaces.touch(),
                    .weight = point.weight,
                    .eta = point.eta,
                    .share_begin = point.share_begin,
                    .share_end = point.share_end,
                    .normal_sign = face.normal_sign(),
                    .anchored = pair.anchored};
  if (pair.mouth_face != kNone) {
    const Vec2 own = at.end[point.face] - at.start[point.face];
    const bool along = (at.end[pair.mouth_face] - at.start[pair.mouth_face]).dot(own) > 0.0;
    out.mouth = along != pair.mouth_at_end ? 1 : -1;
  }
  return out;
}

}  // namespace cleft::contact
