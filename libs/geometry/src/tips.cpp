#include "tips.hpp"

#include <algorithm>
#include <cmath>

#include "cleft/support/error.hpp"

namespace cleft::geometry {

namespace {

[[noreturn]] void too_short(const Crack& crack) {
  throw CrackError(crack, "is too short for the mesh to open; refine the mesh around it or make it longer");
}

const EdgeCrossing& at(const Trace& trace, int crossing) { return trace.crossings[static_cast<std::size_t>(crossing)]; }

// The way on must not run into the crack's own points ahead, which the check of the polyline could not see.
void check_way_on(const Crack& crack, const Vec2& reached, int end) {
  const auto& points = crack.points;
  const std::size_t segments = points.size() - 1;
  const Vec2& nominal = end == 0 ? points.front() : points.back();
  for (std::size_t k = 2; k < segments; ++k) {
    const std::size_t other = end == 0 ? k : segments - 1 - k;
    if (segments_meet(nominal, reached, points[other], points[other + 1])) {
      throw CrackError(
          crack,
          "winds so tightly that its end, led on to an element edge, meets the crack itself; refine the mesh there");
    }
  }
}

bool has_length(const Topology& topology, const Trace& trace, const Crack& crack, const Passage& passage) {
  const Vec2& start = at(trace, passage.in).point;
  const auto moved = [&](const Vec2& point) { return point != start; };
  const auto kinks = kinks_of(topology, trace, crack, passage);
  return moved(at(trace, passage.out).point) || std::any_of(kinks.begin(), kinks.end(), moved);
}

// A tip that was snapped to a node leaves behind passages of no length around this node, which open nothing.
void drop_empty_passages(const Topology& topology, const Trace& trace, const Crack& crack, Chain& chain, int end) {
  auto& passages = chain.passages;
  while (!passages.empty() && !has_length(topology, trace, crack, end == 0 ? passages.front() : passages.back())) {
    passages.erase(end == 0 ? passages.begin() : passages.end() - 1);
  }
}

void settle_tip(const Terrain& terrain, const Tracer& tracer, const Crack& crack, Trace& trace, Chain& chain, int end) {
  Passage& passage = end == 0 ? chain.passages.front() : chain.passages.back();
  const int inner = end == 0 ? passage.out : passage.in;
  const Tracer::Exit exit = tracer.lead_out(trace, passage.element, end);
  const double nominal = tracer.arc_at(end);
  const double back = std::abs(at(trace, inner).s - nominal);
  const double on = std::abs(at(trace, exit.crossing).s - nominal);
  if (crack.tip_radius > 0.0) {
    Passage led_on = passage;
    (end == 0 ? led_on.in : led_on.out) = exit.crossing;
    (end == 0 ? led_on.in_edge : led_on.out_edge) = exit.local_edge;
    trace.tips.push_back({end, led_on});
    chain.passages.erase(end == 0 ? chain.passages.begin() : chain.passages.end() - 1);
    return;
  }
  // Without the margin rounding would choose where both are equally near, as at a node, and the choice depend on
  // direction.
  if (on < back - 1e-9 * terrain.topology.size(passage.element)) {
    check_way_on(crack, at(trace, exit.crossing).point, end);
    (end == 0 ? passage.in : passage.out) = exit.crossing;
    (end == 0 ? passage.in_edge : passage.out_edge) = exit.local_edge;
    if (at(trace, exit.crossing).on_boundary) chain.kind[static_cast<std::size_t>(end)] = CrackEnd::Kind::Mouth;
  } else {
    chain.passages.erase(end == 0 ? chain.passages.begin() : chain.passages.end() - 1);
    if (at(trace, inner).on_boundary) chain.kind[static_cast<std::size_t>(end)] = CrackEnd::Kind::Mouth;
  }
}

bool divides(const Terrain& terrain, const Trace& trace, const Crack& crack, const Chain& chain) {
  const Topology& topology = terrain.topology;
  for (const Passage& passage : chain.passages) {
    if (!has_length(topology, trace, crack, passage)) continue;
    if (passage.first_kink != passage.last_kink) return true;
    const Index from = at(trace, passage.in).snapped_to, to = at(trace, passage.out).snapped_to;
    if (from == kNone || to == kNone) return true;
    for (int k = 0; k < 3; ++k) {
      const Index a = topology.node(passage.element, k), b = topology.node(passage.element, k + 1);
      const bool along_edge = (a == from && b == to) || (a == to && b == from);
      if (along_edge && topology.across({passage.element, k}).triangle != kNone) return true;
    }
  }
  return false;
}

std::size_t closed_ends(const Trace& trace) {
  std::size_t count = 0;
  for (const Chain& chain : trace.chains) {
    for (const auto kind : chain.kind) count += kind == CrackEnd::Kind::Tip ? 1 : 0;
  }
  return count;
}

void collect_tip_nodes(const Trace& trace, const Chain& chain, std::vector<Index>& tip_nodes) {
  for (const int end : {0, 1}) {
    if (chain.kind[static_cast<std::size_t>(end)] == CrackEnd::Kind::Mouth) continue;
    const EdgeCrossing& last = at(trace, end == 0 ? chain.passages.front().in : chain.passages.back().out);
    if (last.snapped_to != kNone) {
      tip_nodes.push_back(last.snapped_to);
    } else {
      tip_nodes.insert(tip_nodes.end(), last.edge.begin(), last.edge.end());
    }
  }
}

}  // namespace

std::vector<Vec2> kinks_of(const Topology& topology, const Trace& trace, const Crack& crack, const Passage& passage) {
  std::vector<Vec2> kinks(crack.points.begin() + passage.first_kink, crack.points.begin() + passage.last_kink);
  if (kinks.empty()) return kinks;
  const double size = topology.size(passage.element);
  for (Vec2& kink : kinks) {
    for (const int crossing : {passage.in, passage.out}) {
      if (crossing >= 0 && (kink - at(trace, crossing).point).norm() <= kSamePoint * size)
        kink = at(trace, crossing).point;
    }
    for (int k = 0; k < 3; ++k) {
      const Vec2& node = topology.corner(passage.element, k);
      if ((kink - node).norm() <= kSnap * size) kink = node;
    }
  }
  return kinks;
}

void settle_tips(const Terrain& terrain, const Tracer& tracer, const Crack& crack, Trace& trace,
                 std::vector<Index>& tip_nodes) {
  if (trace.chains.empty()) {
    throw CrackError(crack, "lies outside of the body; at least a part of a crack must be inside");
  }
  for (Chain& chain : trace.chains) {
    const bool closed_start = chain.kind[0] == CrackEnd::Kind::Tip;
    const bool closed_end = chain.kind[1] == CrackEnd::Kind::Tip;
    if (closed_start && closed_end && chain.passages.size() == 1) too_short(crack);
    if (closed_start) settle_tip(terrain, tracer, crack, trace, chain, 0);
    if (closed_end && !chain.passages.empty()) settle_tip(terrain, tracer, crack, trace, chain, 1);
    if (closed_start) drop_empty_passages(terrain.topology, trace, crack, chain, 0);
    if (closed_end) drop_empty_passages(terrain.topology, trace, crack, chain, 1);
    if (crack.tip_radius > 0.0 && (closed_start || closed_end) && chain.passages.empty()) too_short(crack);
  }
  std::erase_if(trace.chains, [](const Chain& chain) { return chain.passages.empty(); });
  if (trace.chains.empty()) too_short(crack);
  std::erase_if(trace.chains, [&](const Chain& chain) { return !divides(terrain, trace, crack, chain); });
  if (trace.chains.empty()) {
    throw CrackError(crack,
                     "lies outside of the body: it only touches the boundary or runs along it; at least a part of a "
                     "crack must be inside");
  }
  if (!trace.tips.empty() && closed_ends(trace) != trace.tips.size()) too_short(crack);
  for (const Chain& chain : trace.chains) collect_tip_nodes(trace, chain, tip_nodes);
}

}  // namespace cleft::geometry
