#include "cleft/contact/multipliers.hpp"

#include <cmath>

#include "smoothing.hpp"

namespace cleft::contact {
namespace {

// Of a face: places that are no further apart are the same.
constexpr double kTie = 1e-9;

bool has_multipliers_on_both_faces(const Surfaces& surfaces) {
  for (std::size_t c = 0; c < surfaces.mortar.size(); ++c)
    if (surfaces.mortar[c].on && surfaces.sides[c] == NegativeSide::Both) return true;
  return false;
}

// The place nearest to a node that has something opposite.
struct Nearest {
  Index mortar_pair = kNone;
  double away = 0.0, eta = 0.0;
  Bound bound;
};

// Of each node whose other face has hat functions, too.
std::vector<Nearest> nearest_places(const Surfaces& surfaces, const std::vector<MortarSegment>& mortar_segments,
                                    const std::vector<MortarPair>& mortar_pairs) {
  const auto& space = surfaces.multiplier_space;
  std::vector<Nearest> out(space.nodes.size());
  for (Index o = 0; o < static_cast<Index>(mortar_pairs.size()); ++o) {
    const auto& [interval_part, partner, first, last] = mortar_pairs[o];
    if (!space.on(partner)) continue;
    const auto& face = surfaces.faces[space.interval_parts[interval_part].face];
    const double length = face.s_end - face.s_start;
    const auto offer = [&](Index node, double eta, const Bound& bound) {
      const double away = std::fabs(face.s_start + eta * length - space.nodes[node].s);
      // Of two that meet at the node: that of the same face also if the crack's points come in reverse order.
      const double tie = face.side == geometry::Side::Left ? kTie * length : -kTie * length;
      if (out[node].mortar_pair == kNone || away < out[node].away + tie) out[node] = {o, away, eta, bound};
    };
    const auto ends = space.ends(interval_part);
    offer(ends[0], mortar_segments[first].begin, mortar_segments[first].begin_at);
    offer(ends[1], mortar_segments[last - 1].end, mortar_segments[last - 1].end_at);
  }
  return out;
}

}  // namespace

MultiplierState multipliers_at_rest(const Surfaces& surfaces) {
  const auto& space = surfaces.multiplier_space;
  return {std::vector<Status>(space.nodes.size(), Status::Stick),
          VecX::Zero(2 * static_cast<Index>(space.nodes.size())),
          VecX::Zero(static_cast<Index>(space.nodes.size())),
          std::vector<double>(space.intervals.size(), 1.0),
          anchor_maps_at_rest(surfaces),
          std::vector<double>(space.nodes.size(), 0.0),
          std::vector<double>(space.nodes.size(), 0.0),
          0.0,
          std::vector<InterfaceState>(space.nodes.size())};
}

void Multipliers::run(const Surfaces& surfaces, const FacePositions& at, const std::vector<Pair>& pairs, const VecX& x,
                      const MultiplierState& past, Conditions conditions) {
  const auto& space = surfaces.multiplier_space;
  nodes_.assign(space.nodes.size(), {});
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const double scale = mortar_of(surfaces, space.nodes[i]).scale;
    const auto at_x = 2 * (surfaces.first_multiplier + static_cast<Index>(i));
    nodes_[i].normal = scale * x[at_x];
    nodes_[i].tangential = scale * x[at_x + 1];
  }
  find_mortar_pairs(surfaces, at, pairs, past);
  facing_.clear();
  if (has_multipliers_on_both_faces(surfaces)) face_each_other(surfaces, at);
  find_reached(surfaces);
  conditions_.assign(nodes_.size(), {});
  for (Index i = 0; i < static_cast<Index>(nodes_.size()); ++i) choose_conditions(surfaces, i, past, conditions);
}

// theory (8.2)
void Multipliers::find_mortar_pairs(const Surfaces& surfaces, const FacePositions& at, const std::vector<Pair>& pairs,
                                    const MultiplierState& past) {
  const auto& space = surfaces.multiplier_space;
  mortar_segments_ = find_mortar_segments(surfaces, at, pairs, past.anchor_maps);
  mortar_pairs_ = mortar_pairs_of(mortar_segments_);
  integrals_.resize(mortar_pairs_.size());
  by_anchor_.resize(mortar_segments_.size());
  covered_.assign(space.intervals.size(), 0.0);
  for (std::size_t o = 0; o < mortar_pairs_.size(); ++o) {
    const auto& [interval_part, partner, first, last] = mortar_pairs_[o];
    const auto own = static_cast<std::size_t>(first), count = static_cast<std::size_t>(last - first);
    const auto ends = space.ends(interval_part);
    integrate(surfaces, at, past.anchor_maps, std::span(mortar_segments_).subspan(own, count),
              {nodes_[ends[0]].traction(), nodes_[ends[1]].traction()}, integrals_[o],
              std::span(by_anchor_).subspan(own, count));
    const auto& v = integrals_[o].value;
    for (int k = 0; k < 2; ++k) {
      nodes_[ends[k]].gap += v(kGapOutput + 2 * k);
      nodes_[ends[k]].slip += v(kGapOutput + 1 + 2 * k);
      nodes_[ends[k]].support += v(kSupportOutput + k);
      covered_[space.interval_parts[interval_part].interval] += v(kSupportOutput + k);
    }
  }
}

// theory (8.6)
void Multipliers::face_each_other(const Surfaces& surfaces, const FacePositions& at) {
  const auto& space = surfaces.multiplier_space;
  for (std::size_t o = 0; o < mortar_pairs_.size(); ++o) {
    const auto ends = space.ends(mortar_pairs_[o].interval_part);
    for (int k = 0; k < 2; ++k)
      nodes_[ends[k]].reach += integrals_[o].length_ratio.value * integrals_[o].value(kSupportOutput + k);
  }
  facing_.resize(nodes_.size());
  const auto nearest = nearest_places(surfaces, mortar_segments_, mortar_pairs_);
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const auto& [mortar_pair, away, eta, bound] = nearest[i];
    if (mortar_pair == kNone) continue;
    const auto& [interval_part, partner, first, last] = mortar_pairs_[mortar_pair];
    facing_[i] = borne_at(surfaces, mortar_pair,
                          bound.by_partner
                              ? ValueAndGradient{bound.place}
                              : place_opposite(surfaces, at, space.interval_parts[interval_part].face, partner, eta));
  }
}

Facing Multipliers::borne_at(const Surfaces& surfaces, Index mortar_pair, const ValueAndGradient& place) const {
  const auto& space = surfaces.multiplier_space;
  const Index partner = mortar_pairs_[mortar_pair].partner;
  const Index interval_part = space.part_at(partner, place.value);
  const auto hat = [&](double at) {
    return space.second_hat(surfaces.faces[partner], space.interval_parts[interval_part], at);
  };
  const auto opposite = [&](Index node) { return Vec2(nodes_[node].normal, -nodes_[node].tangential); };
  const auto ends = space.ends(interval_part);
  const Vec2 first = opposite(ends[0]), second = opposite(ends[1]);
  const double share = hat(place.value);
  return {mortar_pair,
          interval_part,
          share,
          (1.0 - share) * first + share * second,
          (hat(1.0) - hat(0.0)) * (second - first),
          place};
}

void Multipliers::find_reached(const Surfaces& surfaces) {
  const auto& space = surfaces.multiplier_space;
  reached_.assign(nodes_.size(), false);
  bool reached = false;
  const auto count = static_cast<Index>(nodes_.size());
  for (Index i = 0; i < count; ++i) {
    if (space.nodes[i].before == kNone) reached = false;
    nodes_[i].supported = nodes_[i].support > 0.0;
    reached = reached || nodes_[i].supported;
    reached_[i] = reached;
  }
  for (Index i = count - 2; i >= 0; --i)
    if (space.nodes[i].after != kNone && reached_[i + 1]) reached_[i] = true;
}

// theory (8.1)
Traction Multipliers::traction(const Surfaces& surfaces, Index face, double eta) const {
  const auto& space = surfaces.multiplier_space;
  const IntervalPart& interval_part = space.interval_parts[space.part_at(face, eta)];
  const auto& interval = space.intervals[interval_part.interval];
  const double second = space.second_hat(surfaces.faces[face], interval_part, eta);
  const NodeState &a = nodes_[interval.first], &b = nodes_[interval.second];
  const double normal = (1.0 - second) * a.normal + second * b.normal;
  const double tangential = (1.0 - second) * a.tangential + second * b.tangential;
  const NodeState& nearer = second < 0.5 ? a : b;
  const NodeState& other = second < 0.5 ? b : a;
  return {nearer.status != Status::Open ? nearer.status
          : normal < 0.0                ? other.status
                                        : Status::Open,
          normal, tangential};
}

// theory (8.5): half of the sum of l Z(l)
double Multipliers::stored_energy(const Surfaces& surfaces) const {
  double out = 0.0;
  const auto& space = surfaces.multiplier_space;
  for (std::size_t e = 0; e < space.intervals.size(); ++e) {
    const auto& [first, second, length] = space.intervals[e];
    const Vec2 difference = nodes_[first].traction() - nodes_[second].traction();
    out +=
        0.5 * compliance(mortar_of(surfaces, space.nodes[first]), length, covered_[e]).value * difference.squaredNorm();
  }
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    out += 0.5 * mortar_of(surfaces, space.nodes[i]).compliance *
           nodes_[i].traction().dot(nodes_[i].beyond + nodes_[i].support * nodes_[i].past_mismatch);
  return out;
}

}  // namespace cleft::contact
