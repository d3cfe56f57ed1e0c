#include "cleft/contact/multipliers.hpp"

#include <algorithm>
#include <cmath>

namespace cleft::contact {
namespace {

// The part of an interval below which its nodes lean on their neighbours.
constexpr double kCover = 0.25;

// Of a face: places that are no further apart are the same.
constexpr double kTie = 1e-9;

const Mortar& mortar_of(const Surfaces& surfaces, const HatNode& node) { return surfaces.mortar[node.crack]; }

// kappa_e l_e / 12 of theory (8.4), and its derivative with regard to what is covered.
struct Compliance {
  double value = 0.0, by_cover = 0.0;
};

Compliance compliance(const Mortar& mortar, double length, double covered) {
  const double scale = mortar.compliance * length / 12.0, bare = 1.0 - covered / (kCover * length);
  if (bare <= 0.0) return {mortar.smoothing * scale, 0.0};
  return {(mortar.smoothing + bare) * scale, -scale / (kCover * length)};
}

bool has_hats_on_both_faces(const Surfaces& surfaces) {
  for (std::size_t c = 0; c < surfaces.mortar.size(); ++c)
    if (surfaces.mortar[c].on && surfaces.sides[c] == NegativeSide::Both) return true;
  return false;
}

// The place nearest to a node that has something opposite.
struct Nearest {
  Index overlap = kNone;
  double away = 0.0, eta = 0.0;
  Bound bound;
};

// Of each node whose other face has hats, too.
std::vector<Nearest> nearest_places(const Surfaces& surfaces, const std::vector<Piece>& pieces,
                                    const std::vector<Overlap>& overlaps) {
  const auto& hats = surfaces.hats;
  std::vector<Nearest> out(hats.nodes.size());
  for (Index o = 0; o < static_cast<Index>(overlaps.size()); ++o) {
    const auto& [strip, partner, first, last] = overlaps[o];
    if (!hats.on(partner)) continue;
    const auto& face = surfaces.faces[hats.strips[strip].face];
    const double length = face.s_end - face.s_start;
    const auto offer = [&](Index node, double eta, const Bound& bound) {
      const double away = std::fabs(face.s_start + eta * length - hats.nodes[node].s);
      // Of two that meet at the node: that of the same face also if the crack's points come in reverse order.
      const double tie = face.side == geometry::Side::Left ? kTie * length : -kTie * length;
      if (out[node].overlap == kNone || away < out[node].away + tie) out[node] = {o, away, eta, bound};
    };
    const auto ends = hats.ends(strip);
    offer(ends[0], pieces[first].begin, pieces[first].begin_at);
    offer(ends[1], pieces[last - 1].end, pieces[last - 1].end_at);
  }
  return out;
}

// The part of an interval's past that is still there: it goes with what is covered, below kCover of the length.
// Parts of consecutive increments multiply to that of all of them.
struct Kept {
  double value = 1.0, by_cover = 0.0;
};

Kept kept_of(double length, double covered, double past_coverage) {
  const double now = covered / length, past = std::min(kCover, past_coverage);
  if (now >= past) return {};
  return {now / past, 1.0 / (past * length)};
}

}  // namespace

HatMemory hats_at_rest(const Surfaces& surfaces) {
  const auto& hats = surfaces.hats;
  return {std::vector<Status>(hats.nodes.size(), Status::Stick),
          VecX::Zero(2 * static_cast<Index>(hats.nodes.size())),
          VecX::Zero(static_cast<Index>(hats.nodes.size())),
          std::vector<double>(hats.intervals.size(), 1.0),
          trails_at_rest(surfaces),
          std::vector<double>(hats.nodes.size(), 0.0),
          std::vector<double>(hats.nodes.size(), 0.0),
          0.0};
}

void Multipliers::run(const Surfaces& surfaces, const FacePositions& at, const std::vector<Pair>& pairs, const VecX& x,
                      const HatMemory& memory, Conditions conditions) {
  const auto& hats = surfaces.hats;
  nodes_.assign(hats.nodes.size(), {});
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const double scale = mortar_of(surfaces, hats.nodes[i]).scale;
    const auto at_x = 2 * (surfaces.first_multiplier + static_cast<Index>(i));
    nodes_[i].normal = scale * x[at_x];
    nodes_[i].tangential = scale * x[at_x + 1];
  }
  find_overlaps(surfaces, at, pairs, memory);
  facing_.clear();
  if (has_hats_on_both_faces(surfaces)) face_each_other(surfaces, at);
  find_reached(surfaces);
  conditions_.assign(nodes_.size(), {});
  for (Index i = 0; i < static_cast<Index>(nodes_.size()); ++i) judge(surfaces, i, memory, conditions);
}

// theory (8.2)
void Multipliers::find_overlaps(const Surfaces& surfaces, const FacePositions& at, const std::vector<Pair>& pairs,
                                const HatMemory& memory) {
  const auto& hats = surfaces.hats;
  pieces_ = find_pieces(surfaces, at, pairs, memory.trails);
  overlaps_ = overlaps_of(pieces_);
  integrals_.resize(overlaps_.size());
  by_anchor_.resize(pieces_.size());
  covered_.assign(hats.intervals.size(), 0.0);
  for (std::size_t o = 0; o < overlaps_.size(); ++o) {
    const auto& [strip, partner, first, last] = overlaps_[o];
    const auto own = static_cast<std::size_t>(first), count = static_cast<std::size_t>(last - first);
    const auto ends = hats.ends(strip);
    integrate(surfaces, at, memory.trails, std::span(pieces_).subspan(own, count),
              {nodes_[ends[0]].traction(), nodes_[ends[1]].traction()}, integrals_[o],
              std::span(by_anchor_).subspan(own, count));
    const auto& v = integrals_[o].value;
    for (int k = 0; k < 2; ++k) {
      nodes_[ends[k]].gap += v(kGapOutput + 2 * k);
      nodes_[ends[k]].slip += v(kGapOutput + 1 + 2 * k);
      nodes_[ends[k]].support += v(kSupportOutput + k);
      covered_[hats.strips[strip].interval] += v(kSupportOutput + k);
    }
  }
}

// theory (8.6)
void Multipliers::face_each_other(const Surfaces& surfaces, const FacePositions& at) {
  const auto& hats = surfaces.hats;
  for (std::size_t o = 0; o < overlaps_.size(); ++o) {
    const auto ends = hats.ends(overlaps_[o].strip);
    for (int k = 0; k < 2; ++k)
      nodes_[ends[k]].reach += integrals_[o].length_ratio.value * integrals_[o].value(kSupportOutput + k);
  }
  facing_.resize(nodes_.size());
  const auto nearest = nearest_places(surfaces, pieces_, overlaps_);
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const auto& [overlap, away, eta, bound] = nearest[i];
    if (overlap == kNone) continue;
    const auto& [strip, partner, first, last] = overlaps_[overlap];
    facing_[i] = borne_at(
        surfaces, overlap,
        bound.by_partner ? Moved{bound.place} : place_opposite(surfaces, at, hats.strips[strip].face, partner, eta));
  }
}

Facing Multipliers::borne_at(const Surfaces& surfaces, Index overlap, const Moved& place) const {
  const auto& hats = surfaces.hats;
  const Index partner = overlaps_[overlap].partner;
  const Index strip = hats.strip_at(partner, place.value);
  const auto hat = [&](double at) { return hats.second_hat(surfaces.faces[partner], hats.strips[strip], at); };
  const auto opposite = [&](Index node) { return Vec2(nodes_[node].normal, -nodes_[node].tangential); };
  const auto ends = hats.ends(strip);
  const Vec2 first = opposite(ends[0]), second = opposite(ends[1]);
  const double share = hat(place.value);
  return {overlap, strip, share, (1.0 - share) * first + share * second, (hat(1.0) - hat(0.0)) * (second - first),
          place};
}

void Multipliers::find_reached(const Surfaces& surfaces) {
  const auto& hats = surfaces.hats;
  reached_.assign(nodes_.size(), false);
  bool reached = false;
  const auto count = static_cast<Index>(nodes_.size());
  for (Index i = 0; i < count; ++i) {
    if (hats.nodes[i].before == kNone) reached = false;
    nodes_[i].supported = nodes_[i].support > 0.0;
    reached = reached || nodes_[i].supported;
    reached_[i] = reached;
  }
  for (Index i = count - 2; i >= 0; --i)
    if (hats.nodes[i].after != kNone && reached_[i + 1]) reached_[i] = true;
}

// theory (8.3)
void Multipliers::judge(const Surfaces& surfaces, Index i, const HatMemory& memory, Conditions conditions) {
  const auto& hats = surfaces.hats;
  const auto& node = hats.nodes[i];
  const auto& mortar = mortar_of(surfaces, node);
  const double c = mortar.scale, friction = surfaces.laws[node.crack].friction;
  auto& s = nodes_[i];
  auto& out = conditions_[i];
  const Vec2 own = s.traction();

  Vec2 smooth = Vec2::Zero();  // Z, and its derivatives with regard to tractions and covers
  double by_own = 0.0;
  std::array<double, 2> by_neighbour{};
  std::array<Vec2, 2> by_cover{Vec2::Zero(), Vec2::Zero()};
  for (int k = 0; k < 2; ++k) {
    const Index e = k == 0 ? node.before : node.after;
    if (e == kNone) continue;
    const Index j = k == 0 ? hats.intervals[e].first : hats.intervals[e].second;
    const Compliance soft = compliance(mortar, hats.intervals[e].length, covered_[e]);
    s.leans = s.leans || covered_[e] < kCover * hats.intervals[e].length;
    const Kept kept = s.supported ? kept_of(hats.intervals[e].length, covered_[e], memory.coverage[e]) : Kept{0.0, 0.0};
    s.fades = s.fades || kept.by_cover > 0.0;
    const Vec2 past(0.0, memory.multiplier[2 * i + 1] - memory.multiplier[2 * j + 1]);
    const Vec2 difference = own - nodes_[j].traction() - kept.value * past;
    smooth += soft.value * difference;
    by_own += soft.value;
    by_neighbour[k] = -soft.value;
    by_cover[k] = soft.by_cover * difference - soft.value * kept.by_cover * past;
  }
  const bool faces_hats = !facing_.empty() && facing_[i].overlap != kNone;
  if (faces_hats) {
    s.past_mismatch = {0.0, memory.mismatch[i]};
    s.beyond = s.support * (own - s.past_mismatch) - s.reach * facing_[i].traction;
    smooth += mortar.compliance * s.beyond;
    by_own += mortar.compliance * s.support;
  }
  const auto level = [&](int row, double integral) {  // c (integral - Z)
    out.value(row) = c * (integral - smooth(row));
    out.by_integral(row) = s.supported ? c : 0.0;
    out.by_beyond(row) = faces_hats ? -c * mortar.compliance : 0.0;
    out.by_own(row, row) = -c * c * by_own;
    for (int k = 0; k < 2; ++k) {
      out.by_neighbour[k](row, row) = -c * c * by_neighbour[k];
      out.by_cover[k](row) = -c * by_cover[k](row);
    }
  };

  if (!reached_[i]) {  // the whole face has nothing opposite
    out.value = node.length * own;
    out.by_own = c * node.length * Mat2::Identity();
    return;
  }
  s.smooth = smooth;
  s.plastic_slip = s.supported ? s.slip - smooth.y() : 0.0;
  if (!s.supported) {
    level(0, 0.0);
    level(1, 0.0);
    s.status = s.normal < 0.0 ? Status::Stick : Status::Open;
    return;
  }
  if (conditions == Conditions::Stick) {
    s.status = Status::Stick;
    level(0, s.gap);
    level(1, s.slip);
    return;
  }
  const bool held = memory.status[i] != Status::Open;
  const double touch = c * surfaces.touch().length * node.length;
  const double trial = node.length * s.normal + c * (s.gap - smooth.x());
  if (trial >= (held ? touch : 0.0)) {
    out.value = node.length * own;
    out.by_own = c * node.length * Mat2::Identity();
    return;
  }
  level(0, s.gap);
  const double tangential = node.length * s.tangential + c * (s.slip - smooth.y());
  if (!held) {
    s.status = Status::Stick;
    out.value.y() = node.length * s.tangential;
    out.by_own(1, 1) = c * node.length;
  } else if (std::fabs(tangential) <= friction * std::max(0.0, -trial) + touch ||
             (friction > 0.0 && tangential * s.tangential < 0.0 &&
              std::fabs(s.tangential) > -0.5 * friction * s.normal && s.normal < 0.0)) {
    // Who slides against the traction that it bears has to stick before it may slide the other way: without that nodes
    // would jump from one sense to the other and back. Without friction a traction is rounding and says nothing.
    s.status = Status::Stick;
    level(1, s.slip);
  } else {
    s.status = Status::Slip;
    s.slides = std::copysign(1.0, tangential);
    const double strength = s.slides * friction;
    out.value.y() = node.length * (s.tangential + strength * s.normal);
    out.by_own(1, 1) = c * node.length;
    out.by_own(1, 0) = c * node.length * strength;
  }
}

// theory (8.1)
Traction Multipliers::traction(const Surfaces& surfaces, Index face, double eta) const {
  const auto& hats = surfaces.hats;
  const Strip& strip = hats.strips[hats.strip_at(face, eta)];
  const auto& interval = hats.intervals[strip.interval];
  const double second = hats.second_hat(surfaces.faces[face], strip, eta);
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
  const auto& hats = surfaces.hats;
  for (std::size_t e = 0; e < hats.intervals.size(); ++e) {
    const auto& [first, second, length] = hats.intervals[e];
    const Vec2 difference = nodes_[first].traction() - nodes_[second].traction();
    out +=
        0.5 * compliance(mortar_of(surfaces, hats.nodes[first]), length, covered_[e]).value * difference.squaredNorm();
  }
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    out += 0.5 * mortar_of(surfaces, hats.nodes[i]).compliance *
           nodes_[i].traction().dot(nodes_[i].beyond + nodes_[i].support * nodes_[i].past_mismatch);
  return out;
}

}  // namespace cleft::contact
