#include "multiplier_transfer.hpp"

#include <algorithm>
#include <cmath>

#include "contact_transfer.hpp"

namespace cleft::growth {
namespace {

using assembly::Model;
using contact::AnchorMap;

constexpr double kShortestAnchorMap = 1e-12;  // of a face: a shorter one is what rounding leaves between two

bool same_side(const enrichment::Face& a, const enrichment::Face& b) { return a.crack == b.crack && a.side == b.side; }

// The interval of a crack and side that holds an arc length, or kNone.
Index interval_at(const Model& m, const contact::MultiplierNode& where, double s) {
  const auto& space = m.surfaces.multiplier_space;
  for (Index e = 0; e < static_cast<Index>(space.intervals.size()); ++e) {
    const auto &first = space.nodes[space.intervals[e].first], &second = space.nodes[space.intervals[e].second];
    if (first.crack == where.crack && first.side == where.side && first.s <= s && s <= second.s) return e;
  }
  return kNone;
}

// The part [first, last] (arc lengths) of an anchor map on the old model.
struct OldAnchorMap {
  const Model& model;
  const AnchorMap& anchor_map;
  double first, last;
};

// Adds it on a new face, by the new faces that hold its anchors.
void add_anchor_map(const OldAnchorMap& old, const Model& to, Index face, std::vector<AnchorMap>& out) {
  const auto& own = to.surfaces.faces[face];
  const auto &was = old.model.surfaces.faces[old.anchor_map.face],
             &anchor = old.model.surfaces.faces[old.anchor_map.anchor_face];
  const double s0 = at(was, old.anchor_map.begin), a0 = at(anchor, old.anchor_map.anchor_begin);
  const double slope = (at(anchor, old.anchor_map.anchor_end) - a0) / (at(was, old.anchor_map.end) - s0);
  const auto add = [&](Index g, double low, double high) {
    const auto& there = to.surfaces.faces[g];
    const double begin = place_on(own, low), end = place_on(own, high);
    if (end > begin + kShortestAnchorMap)
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

std::vector<AnchorMap> anchor_maps_on(const Model& from, const std::vector<AnchorMap>& anchor_maps,
                                      const std::vector<Kept>& kept, const Model& to) {
  std::vector<AnchorMap> out;
  for (const AnchorMap& rest : contact::anchor_maps_at_rest(to.surfaces)) {
    const auto& face = to.surfaces.faces[rest.face];
    const Kept& old = kept[face.crack];
    const double first = std::clamp(face.s_start, old.first, old.last),
                 last = std::clamp(face.s_end, old.first, old.last);
    const auto begins = static_cast<std::ptrdiff_t>(out.size());
    for (const AnchorMap& anchor_map : anchor_maps) {
      const auto& was = from.surfaces.faces[anchor_map.face];
      if (!same_side(was, face)) continue;
      const double low = std::max(first, at(was, anchor_map.begin)), high = std::min(last, at(was, anchor_map.end));
      if (low < high) add_anchor_map({from, anchor_map, low, high}, to, rest.face, out);
    }
    const auto at_rest = [&](double low, double high) {
      const double begin = place_on(face, low), end = place_on(face, high);
      if (end > begin + kShortestAnchorMap) out.push_back({rest.face, begin, end, rest.anchor_face, begin, end});
    };
    at_rest(face.s_start, std::min(face.s_end, old.first));
    at_rest(std::max(face.s_start, old.last), face.s_end);
    std::sort(out.begin() + begins, out.end(),
              [](const AnchorMap& a, const AnchorMap& b) { return a.begin < b.begin; });
  }
  return out;
}

}  // namespace

contact::MultiplierState multipliers_on(const Model& from, const contact::MultiplierState& past, const Model& to) {
  if (to.surfaces.multiplier_space.empty()) return {};
  const auto kept = kept_parts(from, to);
  const auto &old = from.surfaces.multiplier_space, &now = to.surfaces.multiplier_space;
  contact::MultiplierState out = contact::multipliers_at_rest(to.surfaces);
  for (Index i = 0; i < static_cast<Index>(now.nodes.size()); ++i) {
    const auto& node = now.nodes[i];
    const Index e = kept[node.crack].holds(node.s) ? interval_at(from, node, node.s) : kNone;
    if (e == kNone) continue;
    const auto& interval = old.intervals[e];
    const double first = old.nodes[interval.first].s, second = old.nodes[interval.second].s;
    const double share = (node.s - first) / (second - first);
    out.multiplier.segment<2>(2 * i) = (1.0 - share) * past.multiplier.segment<2>(2 * interval.first) +
                                       share * past.multiplier.segment<2>(2 * interval.second);
    const auto between = [&](const auto& of_node) {
      return (1.0 - share) * of_node[interval.first] + share * of_node[interval.second];
    };
    out.slope[i] = between(past.slope);
    out.smooth[i] = between(past.smooth);
    out.mismatch[i] = between(past.mismatch);
    out.state[i].slip = (1.0 - share) * past.state[interval.first].slip + share * past.state[interval.second].slip;
    out.status[i] = past.status[share < 0.5 ? interval.first : interval.second];
  }
  for (std::size_t k = 0; k < now.intervals.size(); ++k) {
    const auto &first = now.nodes[now.intervals[k].first], &second = now.nodes[now.intervals[k].second];
    const double middle = 0.5 * (first.s + second.s);
    const Index e = kept[first.crack].holds(middle) ? interval_at(from, first, middle) : kNone;
    if (e != kNone) out.coverage[k] = past.coverage[e];
  }
  out.stored = past.stored;
  out.anchor_maps = anchor_maps_on(from, past.anchor_maps, kept, to);
  return out;
}

void put_multipliers(const Model& model, const contact::MultiplierState& past, VecX& components) {
  const auto& surfaces = model.surfaces;
  for (Index i = 0; i < static_cast<Index>(surfaces.multiplier_space.nodes.size()); ++i)
    components.segment<2>(2 * (surfaces.first_multiplier + i)) =
        past.multiplier.segment<2>(2 * i) / surfaces.mortar[surfaces.multiplier_space.nodes[i].crack].scale;
}

}  // namespace cleft::growth
