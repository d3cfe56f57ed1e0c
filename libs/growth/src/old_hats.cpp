#include "old_hats.hpp"

#include <algorithm>
#include <cmath>

#include "old_faces.hpp"

namespace cleft::growth {
namespace {

using assembly::Model;
using contact::Trail;

constexpr double kShortestTrail = 1e-12;  // of a face: a shorter one is what rounding leaves between two

bool same_side(const enrichment::Face& a, const enrichment::Face& b) { return a.crack == b.crack && a.side == b.side; }

// The interval of a crack and side that holds an arc length, or kNone.
Index interval_at(const Model& m, const contact::HatNode& where, double s) {
  const auto& hats = m.surfaces.hats;
  for (Index e = 0; e < static_cast<Index>(hats.intervals.size()); ++e) {
    const auto &first = hats.nodes[hats.intervals[e].first], &second = hats.nodes[hats.intervals[e].second];
    if (first.crack == where.crack && first.side == where.side && first.s <= s && s <= second.s) return e;
  }
  return kNone;
}

// The part [first, last] (arc lengths) of a trail on the old model.
struct OldTrail {
  const Model& model;
  const Trail& trail;
  double first, last;
};

// Adds it on a new face, by the new faces that hold its anchors.
void add_trail(const OldTrail& old, const Model& to, Index face, std::vector<Trail>& out) {
  const auto& own = to.surfaces.faces[face];
  const auto &was = old.model.surfaces.faces[old.trail.face], &anchor = old.model.surfaces.faces[old.trail.anchor_face];
  const double s0 = at(was, old.trail.begin), a0 = at(anchor, old.trail.anchor_begin);
  const double slope = (at(anchor, old.trail.anchor_end) - a0) / (at(was, old.trail.end) - s0);
  const auto add = [&](Index g, double low, double high) {
    const auto& there = to.surfaces.faces[g];
    const double begin = place_on(own, low), end = place_on(own, high);
    if (end > begin + kShortestTrail)
      out.push_back(
          {face, begin, end, g, place_on(there, a0 + slope * (low - s0)), place_on(there, a0 + slope * (high - s0))});
  };
  if (to.surfaces.undeformed) return add(enrichment::opposite_face(face), old.first, old.last);
  for (Index g = 0; g < static_cast<Index>(to.surfaces.faces.size()); ++g) {
    const auto& there = to.surfaces.faces[g];
    if (!same_side(there, anchor)) continue;
    double low = s0 + (there.s_start - a0) / slope, high = s0 + (there.s_end - a0) / slope;
    if (low > high) std::swap(low, high);
    add(g, std::max(old.first, low), std::min(old.last, high));
  }
}

std::vector<Trail> trails_on(const Model& from, const std::vector<Trail>& trails, const std::vector<Kept>& kept,
                             const Model& to) {
  std::vector<Trail> out;
  for (const Trail& rest : contact::trails_at_rest(to.surfaces)) {
    const auto& face = to.surfaces.faces[rest.face];
    const Kept& old = kept[face.crack];
    const double first = std::clamp(face.s_start, old.first, old.last),
                 last = std::clamp(face.s_end, old.first, old.last);
    const auto begins = static_cast<std::ptrdiff_t>(out.size());
    for (const Trail& trail : trails) {
      const auto& was = from.surfaces.faces[trail.face];
      if (!same_side(was, face)) continue;
      const double low = std::max(first, at(was, trail.begin)), high = std::min(last, at(was, trail.end));
      if (low < high) add_trail({from, trail, low, high}, to, rest.face, out);
    }
    const auto at_rest = [&](double low, double high) {
      const double begin = place_on(face, low), end = place_on(face, high);
      if (end > begin + kShortestTrail) out.push_back({rest.face, begin, end, rest.anchor_face, begin, end});
    };
    at_rest(face.s_start, std::min(face.s_end, old.first));
    at_rest(std::max(face.s_start, old.last), face.s_end);
    std::sort(out.begin() + begins, out.end(), [](const Trail& a, const Trail& b) { return a.begin < b.begin; });
  }
  return out;
}

}  // namespace

contact::HatMemory hats_on(const Model& from, const contact::HatMemory& memory, const Model& to) {
  if (to.surfaces.hats.empty()) return {};
  const auto kept = kept_parts(from, to);
  const auto &old = from.surfaces.hats, &now = to.surfaces.hats;
  contact::HatMemory out = contact::hats_at_rest(to.surfaces);
  for (Index i = 0; i < static_cast<Index>(now.nodes.size()); ++i) {
    const auto& node = now.nodes[i];
    const Index e = kept[node.crack].holds(node.s) ? interval_at(from, node, node.s) : kNone;
    if (e == kNone) continue;
    const auto& interval = old.intervals[e];
    const double first = old.nodes[interval.first].s, second = old.nodes[interval.second].s;
    const double share = (node.s - first) / (second - first);
    out.multiplier.segment<2>(2 * i) = (1.0 - share) * memory.multiplier.segment<2>(2 * interval.first) +
                                       share * memory.multiplier.segment<2>(2 * interval.second);
    const auto between = [&](const auto& of_node) {
      return (1.0 - share) * of_node[interval.first] + share * of_node[interval.second];
    };
    out.slope[i] = between(memory.slope);
    out.smooth[i] = between(memory.smooth);
    out.mismatch[i] = between(memory.mismatch);
    out.state[i].slip = (1.0 - share) * memory.state[interval.first].slip + share * memory.state[interval.second].slip;
    out.status[i] = memory.status[share < 0.5 ? interval.first : interval.second];
  }
  for (std::size_t k = 0; k < now.intervals.size(); ++k) {
    const auto &first = now.nodes[now.intervals[k].first], &second = now.nodes[now.intervals[k].second];
    const double middle = 0.5 * (first.s + second.s);
    const Index e = kept[first.crack].holds(middle) ? interval_at(from, first, middle) : kNone;
    if (e != kNone) out.coverage[k] = memory.coverage[e];
  }
  out.stored = memory.stored;
  out.trails = trails_on(from, memory.trails, kept, to);
  return out;
}

void put_multipliers(const Model& model, const contact::HatMemory& memory, VecX& components) {
  const auto& surfaces = model.surfaces;
  for (Index i = 0; i < static_cast<Index>(surfaces.hats.nodes.size()); ++i)
    components.segment<2>(2 * (surfaces.first_multiplier + i)) =
        memory.multiplier.segment<2>(2 * i) / surfaces.mortar[surfaces.hats.nodes[i].crack].scale;
}

}  // namespace cleft::growth
