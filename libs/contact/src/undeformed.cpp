#include "cleft/contact/undeformed.hpp"

namespace cleft::contact {
namespace {

struct FixedFrame {
  Vec2 t, n;
  double length;
};

FixedFrame fixed_frame(const enrichment::Face& face) {
  const Vec2 along = face.reference_end - face.reference_start;
  const double length = along.norm();
  const Vec2 t = along / length;
  return {t, face.normal_sign() * turn_left(t), length};
}

Vec2 jump(const Surfaces& surfaces, const FacePositions& at, Index p) {
  const Point& point = surfaces.points[p];
  const Index own = point.face, other = enrichment::opposite_face(own);
  return (1.0 - point.eta) * (at.start[other] - at.start[own]) + point.eta * (at.end[other] - at.end[own]);
}

}  // namespace

// theory (6.4)
Pair opposite(const Surfaces& surfaces, const FacePositions& at, Index p, const ContactState& past) {
  const Point& point = surfaces.points[p];
  const auto& face = surfaces.faces[point.face];
  const FixedFrame f = fixed_frame(face);
  const Vec2 d = jump(surfaces, at, p);
  Pair pair;
  pair.partner_face = enrichment::opposite_face(point.face);
  pair.anchored = holds_on(surfaces, past, pair.partner_face);
  PairState& s = pair.state;
  s.partner = point.eta;
  s.stretch_length = f.length;
  s.normal_gap = d.dot(f.n);
  if (pair.anchored) s.tangential_gap = d.dot(f.t) + (past.anchor_place - point.eta) * f.length;
  s.traction = response(surfaces, p, pair, past).traction;
  return pair;
}

PairForce force_undeformed(const Surfaces& surfaces, Index p, const Pair& pair, const ContactState& past) {
  const Point& point = surfaces.points[p];
  const FixedFrame f = fixed_frame(surfaces.faces[point.face]);
  const Traction& t0 = pair.state.traction;
  const ContactResponse answer = response(surfaces, p, pair, past);
  const Stiffness& k0 = answer.stiffness;
  Mat2 stiffness = k0.normal * f.n * f.n.transpose();  // d t_0 / d jump
  if (k0.by_normal != 0.0) stiffness += k0.by_normal * k0.normal * f.t * f.n.transpose();
  if (k0.tangential != 0.0) stiffness += k0.tangential * f.t * f.t.transpose();
  const std::array<double, 4> weight{point.eta - 1.0, -point.eta, 1.0 - point.eta, point.eta};
  PairForce out;
  out.tangent.setZero();
  for (int k = 0; k < 4; ++k) {
    out.force.segment<2>(2 * k) = point.weight * weight[k] * (t0.normal * f.n + t0.tangential * f.t);
    for (int l = 0; l < 4; ++l)
      out.tangent.block<2, 2>(2 * k, 2 * l) = point.weight * weight[k] * weight[l] * stiffness;
  }
  return out;
}

double anchor_place_at(const Surfaces& surfaces, const FacePositions& at, Index p, double target) {
  const Point& point = surfaces.points[p];
  const FixedFrame f = fixed_frame(surfaces.faces[point.face]);
  return point.eta + (target - jump(surfaces, at, p).dot(f.t)) / f.length;
}

}  // namespace cleft::contact
