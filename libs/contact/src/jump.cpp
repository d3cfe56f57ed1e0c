#include "cleft/contact/jump.hpp"

#include <algorithm>

namespace cleft::contact {
namespace {

Vec2 direction(const Surfaces& surfaces, const FacePositions& at, Index left, Index right) {
  const auto& face = surfaces.faces[left];
  const Vec2 reference = (face.reference_end - face.reference_start).normalized();
  if (surfaces.undeformed) return reference;
  const Vec2 both = (at.end[left] - at.start[left]).normalized() + (at.end[right] - at.start[right]).normalized();
  const double length = both.norm();
  return length > 0.0 ? Vec2(both / length) : reference;
}

}  // namespace

Jump jump_at(const Surfaces& surfaces, const FacePositions& at, Index face, double eta) {
  const Index other = enrichment::opposite_face(face);
  const bool is_left = surfaces.faces[face].side == geometry::Side::Left;
  const Index left = is_left ? face : other, right = is_left ? other : face;
  const Vec2 jump = (1.0 - eta) * (at.start[left] - at.start[right]) + eta * (at.end[left] - at.end[right]);
  const Vec2 t = direction(surfaces, at, left, right);
  return {jump.dot(turn_left(t)), jump.dot(t)};
}

double opening_of(const Pair& pair, const Jump& jump) {
  return std::max(0.0, pair.partner_face == kNone ? jump.normal : pair.state.normal_gap);
}

}  // namespace cleft::contact
