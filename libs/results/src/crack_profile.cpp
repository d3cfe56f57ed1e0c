#include "cleft/results/crack_profile.hpp"

#include <cmath>
#include <limits>
#include <numeric>

#include "cleft/contact/jump.hpp"

namespace cleft::results {
namespace {

// The frame of a face where it is now: its tangent along the crack's direction, and its outward normal.
struct FaceFrame {
  Vec2 t, n;
};

FaceFrame frame_of(const contact::Surfaces& surfaces, const contact::FacePositions& at, Index face) {
  const Vec2 t = (at.end[face] - at.start[face]).normalized();
  return {t, surfaces.faces[face].normal_sign() * turn_left(t)};
}

// The part of a face's tractions that its own points exert.
double share_of(const contact::Surfaces& surfaces, const enrichment::Face& face) {
  return surfaces.sides[face.crack] == contact::NegativeSide::Both ? 0.5 : 1.0;
}

// Values at contact points, as continuous functions along the faces that carry them.
class AlongFaces {
 public:
  AlongFaces(const contact::Surfaces& surfaces, const std::vector<contact::Pair>& pairs)
      : surfaces_(surfaces), pairs_(pairs), first_(surfaces.faces.size() + 1, 0) {
    for (const auto& point : surfaces.points) ++first_[point.face + 1];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
  }

  // At a place on a face (0 to 1 along it) that has something opposite: linear between the two points around it, of
  // which one past the end of the other face has no say. Without points there is nothing.
  Vec2 at(Index face, double eta, const std::vector<Vec2>& values) const {
    if (first_[face] == first_[face + 1]) return Vec2::Zero();
    Index after = first_[face];
    while (after < first_[face + 1] && surfaces_.points[after].eta < eta) ++after;
    const Index previous = surfaces_.faces[face].previous, next = surfaces_.faces[face].next;
    Index before = after > first_[face] ? after - 1 : previous != kNone ? first_[previous + 1] - 1 : kNone;
    if (after == first_[face + 1]) after = next != kNone ? first_[next] : kNone;
    if (!is_covered(before)) before = kNone;
    if (!is_covered(after)) after = kNone;
    if (before == kNone) return after == kNone ? Vec2(Vec2::Zero()) : values[after];
    if (after == kNone) return values[before];
    const double part = (s_at(face, eta) - s_of(before)) / (s_of(after) - s_of(before));
    return (1.0 - part) * values[before] + part * values[after];
  }

 private:
  bool is_covered(Index p) const {
    constexpr double kVertex = 1e-9;
    if (p == kNone || pairs_[p].partner_face == kNone) return false;
    return std::fabs(pairs_[p].state.partner - 0.5) <= 0.5 + kVertex;
  }
  double s_at(Index f, double eta) const {
    const auto& face = surfaces_.faces[f];
    return face.s_start + eta * (face.s_end - face.s_start);
  }
  double s_of(Index p) const { return s_at(surfaces_.points[p].face, surfaces_.points[p].eta); }

  const contact::Surfaces& surfaces_;
  const std::vector<contact::Pair>& pairs_;
  std::vector<Index> first_;  // point of each face, and one more
};

// What points exert on their own face and opposite, per current length of each, before the ramp at a mouth, Pa.
struct Exerted {
  std::vector<Vec2> on_own, on_partner;
};

double stretch_of(const enrichment::Face& face, const contact::PairState& state) {
  return state.stretch_length / (face.reference_end - face.reference_start).norm();
}

// At small strain, too, where contact only knows displacements.
contact::FacePositions current_places(const assembly::Model& m, const VecX& displacement) {
  contact::FacePositions out;
  for (const auto& face : m.surfaces.faces) {
    out.start.push_back(face.reference_start + face.start.displacement(displacement));
    out.end.push_back(face.reference_end + face.end.displacement(displacement));
  }
  return out;
}

Exerted exerted_by(const solve::LoadStepper& stepper, const contact::FacePositions& at) {
  const auto& surfaces = stepper.model().surfaces;
  const std::size_t count = stepper.pairs().size();
  Exerted out{std::vector<Vec2>(count, Vec2::Zero()), std::vector<Vec2>(count, Vec2::Zero())};
  for (std::size_t p = 0; p < count; ++p) {
    const auto& pair = stepper.pairs()[p];
    if (pair.partner_face == kNone) continue;
    const Index own = surfaces.points[p].face;
    const auto& face = surfaces.faces[own];
    const auto& s = pair.state;
    const FaceFrame f = frame_of(surfaces, at, own), other = frame_of(surfaces, at, pair.partner_face);
    const double factor = share_of(surfaces, face) / stretch_of(face, s);
    out.on_own[p] = factor * (s.traction.normal * f.n + s.traction.tangential * f.t);
    out.on_partner[p] = -std::fabs(f.t.dot(other.t)) * out.on_own[p];
  }
  return out;
}

}  // namespace

std::vector<ProfilePoint> crack_profile(const solve::LoadStepper& stepper) {
  const auto& model = stepper.model();
  const auto& surfaces = model.surfaces;
  const auto at = current_places(model, stepper.state().displacement);
  const AlongFaces along(surfaces, stepper.pairs());
  const Exerted exerted = exerted_by(stepper, at);
  std::vector<ProfilePoint> out;
  for (std::size_t p = 0; p < stepper.pairs().size(); ++p) {
    const auto& point = surfaces.points[p];
    const auto& face = surfaces.faces[point.face];
    const auto& pair = stepper.pairs()[p];
    const auto blend = [&](const auto& a, const auto& b) { return (1.0 - point.eta) * a + point.eta * b; };
    ProfilePoint q;
    q.crack = face.crack;
    q.side = face.side;
    q.s = blend(face.s_start, face.s_end);
    q.reference = model.in_scene(blend(face.reference_start, face.reference_end));
    q.current = model.in_scene(blend(at.start[point.face], at.end[point.face]));
    q.slip = stepper.state().history.contact[p].state.slip;
    q.gap = q.partner_s = std::numeric_limits<double>::quiet_NaN();
    const contact::Jump jump = contact::jump_at(surfaces, stepper.face_positions(), point.face, point.eta);
    q.jump_normal = jump.normal;
    q.jump_tangential = jump.tangential;
    q.opening = contact::opening_of(pair, jump);
    if (pair.partner_face != kNone) {
      const auto& s = pair.state;
      const auto& other = surfaces.faces[pair.partner_face];
      q.gap = s.normal_gap;
      q.partner_s = other.s_start + s.partner * (other.s_end - other.s_start);
      q.status = s.traction.status;
      const FaceFrame f = frame_of(surfaces, at, point.face), f_other = frame_of(surfaces, at, pair.partner_face);
      const double part = share_of(surfaces, face), stretch = stretch_of(face, s);
      // what the other face's points exert here, if it has any, and on their own face
      const Vec2 here = along.at(pair.partner_face, s.partner, exerted.on_partner),
                 there = along.at(pair.partner_face, s.partner, exerted.on_own);
      q.normal = s.ramp * (part * s.traction.normal + stretch * here.dot(f.n));
      q.tangential = s.ramp * (part * s.traction.tangential + stretch * here.dot(f.t));
      q.pressure = 0.0 - q.normal / stretch;  // of no traction 0, not -0
      q.partner_pressure = 0.0 - s.ramp * (exerted.on_partner[p] + there).dot(f_other.n);
    }
    out.push_back(q);
  }
  return out;
}

}  // namespace cleft::results
