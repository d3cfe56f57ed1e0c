// What the hat functions remember, and the work of their tractions.
#include <algorithm>
#include <cmath>
#include <optional>

#include "cleft/contact/multipliers.hpp"
#include "friction_work.hpp"

namespace cleft::contact {
namespace {

// Of what lies opposite against the face.
double slope_of(const Surfaces& surfaces, const FacePositions& at, Index face, Index partner) {
  if (surfaces.undeformed) return 0.0;
  const Vec2 own = at.end[face] - at.start[face], e = at.end[partner] - at.start[partner];
  return surfaces.faces[face].normal_sign() * e.dot(turn_left(own)) / e.dot(own);
}

bool is_free(const enrichment::Face& face, const Bound& bound) {
  return (bound.place == 0.0 ? face.previous : face.next) == kNone;
}

double arc_length(const enrichment::Face& face, double eta) { return face.s_start + eta * (face.s_end - face.s_start); }

// The arc length on the other face that was opposite an end of `partner` when the last increment had converged.
std::optional<double> place_before(const Surfaces& surfaces, const std::vector<AnchorMap>& anchor_maps, Index partner,
                                   double end) {
  constexpr double kSame = 1e-6;
  for (const auto& anchor_map : anchor_maps) {
    if (anchor_map.anchor_face != partner) continue;
    if (std::fabs(anchor_map.anchor_begin - end) < kSame)
      return arc_length(surfaces.faces[anchor_map.face], anchor_map.begin);
    if (std::fabs(anchor_map.anchor_end - end) < kSame)
      return arc_length(surfaces.faces[anchor_map.face], anchor_map.end);
  }
  return std::nullopt;
}

// g_N where an end of the partner is opposite.
double gap_at(const FacePositions& at, const enrichment::Face& face, Index own, double eta, Index partner,
              const Bound& bound) {
  const Vec2 along = at.end[own] - at.start[own];
  const Vec2& end = bound.place == 0.0 ? at.start[partner] : at.end[partner];
  return face.normal_sign() * (end - at.start[own] - eta * along).dot(turn_left(along)) / along.norm();
}

}  // namespace

MultiplierState Multipliers::remembered(const Surfaces& surfaces, const FacePositions& at) const {
  const auto& space = surfaces.multiplier_space;
  MultiplierState out;
  const auto count = static_cast<Index>(nodes_.size());
  out.multiplier.resize(2 * count);
  out.mismatch = VecX::Zero(count);
  for (Index i = 0; i < count; ++i) {
    const NodeState& node = nodes_[i];
    out.status.push_back(node.status);
    out.multiplier.segment<2>(2 * i) = node.traction();
    if (node.supported) out.mismatch[i] = node.past_mismatch.y() + node.beyond.y() / node.support;
  }
  for (std::size_t e = 0; e < covered_.size(); ++e) out.coverage.push_back(covered_[e] / space.intervals[e].length);
  out.anchor_maps = anchor_maps_of(surfaces, at, mortar_segments_);
  for (const auto& node : nodes_) out.smooth.push_back(node.smooth.x());
  out.stored = stored_energy(surfaces);
  out.slope.assign(nodes_.size(), 0.0);
  for (std::size_t o = 0; o < mortar_pairs_.size(); ++o) {
    const auto& [interval_part, partner, first, last] = mortar_pairs_[o];
    const double slope = slope_of(surfaces, at, space.interval_parts[interval_part].face, partner);
    const auto ends = space.ends(interval_part);
    for (int k = 0; k < 2; ++k)
      if (nodes_[ends[k]].supported)
        out.slope[ends[k]] += slope * integrals_[o].value(kSupportOutput + k) / nodes_[ends[k]].support;
  }
  return out;
}

double Multipliers::friction_work(const Surfaces& surfaces, Index i, const MultiplierState& before) const {
  const auto& node = nodes_[i];
  const auto& at = surfaces.multiplier_space.nodes[i];
  const double slide = std::fabs(node.plastic_slip) / at.length;
  const auto strength_at = [&](double pressure) {
    return strength(surfaces.laws[at.crack], pressure, before.state[i]).value;
  };
  const double at_end = strength_at(std::fabs(node.normal));
  if (before.status[i] == Status::Open)
    return node.status == Status::Open ? 0.0 : at.length * touching_friction_of(at_end, slide);
  if (node.status == Status::Stick) return 0.0;
  const double traction = std::copysign(1.0, node.plastic_slip) * before.multiplier[2 * i + 1];
  return at.length * friction_of({traction, strength_at(std::fabs(before.multiplier[2 * i])), at_end,
                                  surfaces.mortar[at.crack].scale, slide});
}

// Gap and elastic slip are Z where a node is held. Where faces with hat functions slide past each other, or past an
// end, Z changes with the place, too, and takes up what it does not store.
double Multipliers::smoothing_work(Index i, const MultiplierState& before) const {
  const auto& node = nodes_[i];
  if (!node.supported) return 0.0;
  const Vec2 mean = 0.5 * (before.multiplier.segment<2>(2 * i) + node.traction());
  return mean.dot(Vec2(node.smooth.x() - before.smooth[i], node.smooth.y()));
}

// What lies opposite the end of the other face, and bears a pressure through a gap of either sign, is let go as that
// end moves on: by t_N g_N per length. G misses it, since less of the face counts.
double Multipliers::mouth_work(const Surfaces& surfaces, const FacePositions& at, const MultiplierState& before) const {
  const auto& space = surfaces.multiplier_space;
  double out = 0.0;
  for (const auto& mortar_segment : mortar_segments_)
    for (const bool at_end : {false, true}) {
      const Bound& bound = at_end ? mortar_segment.end_at : mortar_segment.begin_at;
      if (!bound.by_partner || !is_free(surfaces.faces[mortar_segment.partner], bound)) continue;
      const auto old = place_before(surfaces, before.anchor_maps, mortar_segment.partner, bound.place);
      if (!old) continue;
      const IntervalPart& interval_part = space.interval_parts[mortar_segment.interval_part];
      const auto& face = surfaces.faces[interval_part.face];
      const double eta = at_end ? mortar_segment.end : mortar_segment.begin;
      const double moved = arc_length(face, eta) - *old;
      const double pressure = traction(surfaces, interval_part.face, eta).normal;
      const auto& interval = space.intervals[interval_part.interval];
      const double factor = interval.length / (space.nodes[interval.second].s - space.nodes[interval.first].s);
      out += factor * (at_end ? -moved : moved) * pressure *
             gap_at(at, face, interval_part.face, eta, mortar_segment.partner, bound);
    }
  return out;
}

// theory (8.7)
CommittedMultipliers Multipliers::commit(const Surfaces& surfaces, const FacePositions& at,
                                         const MultiplierState& before) const {
  CommittedMultipliers out{remembered(surfaces, at)};
  out.pressure = before.stored - out.end.stored + mouth_work(surfaces, at, before);
  out.end.state = before.state;
  for (Index i = 0; i < static_cast<Index>(nodes_.size()); ++i) {
    if (nodes_[i].status == Status::Slip)
      out.end.state[i].slip += std::fabs(nodes_[i].plastic_slip) / surfaces.multiplier_space.nodes[i].length;
    out.friction += friction_work(surfaces, i, before);
    out.pressure += smoothing_work(i, before);
    out.pressure +=
        0.5 * nodes_[i].slip * (before.multiplier[2 * i] * before.slope[i] + nodes_[i].normal * out.end.slope[i]);
  }
  return out;
}

}  // namespace cleft::contact
