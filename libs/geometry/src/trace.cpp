#include "trace.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace cleft::geometry {

Tracer::Tracer(const Terrain& terrain, const Crack& crack) : terrain_(terrain), crack_(crack), arc_{crack.s_first} {
  for (int k = 0; k <= last_segment(); ++k) arc_.push_back(arc_.back() + (line(k).end - line(k).start).norm());
}

double Tracer::arc_length(const Vec2& point, int segment) const {
  const Line on = line(segment);
  return arc_[static_cast<std::size_t>(segment)] + (point - on.start).dot((on.end - on.start).normalized());
}

// Of a triangle's nodes some lie left and some right of a line through it. Counter-clockwise, the line leaves where
// they change from right to left and enters where they change back; each happens once.
int Tracer::leaving_edge(Index triangle, const Line& line, bool backward) const {
  const Topology& topology = terrain_.topology;
  std::array<int, 3> side{};
  for (int k = 0; k < 3; ++k)
    side[static_cast<std::size_t>(k)] = side_of_shifted_line(line.start, line.end, topology.corner(triangle, k));
  const int from = backward ? 1 : -1;
  for (int k = 0; k < 3; ++k) {
    if (side[static_cast<std::size_t>(k)] == from && side[static_cast<std::size_t>((k + 1) % 3)] == -from) return k;
  }
  assert(false && "the line does not pass through the triangle");
  return 0;
}

int Tracer::add_crossing(Trace& trace, TriangleEdge edge, int segment, bool on_boundary) const {
  const Topology& topology = terrain_.topology;
  EdgeCrossing crossing;
  const auto [low, high] =
      std::minmax({topology.node(edge.triangle, edge.local), topology.node(edge.triangle, edge.local + 1)});
  crossing.edge = {low, high};
  crossing.line = line(segment);
  crossing.on_boundary = on_boundary;
  const Vec2& a = topology.mesh().nodes[static_cast<std::size_t>(low)];
  const Vec2& b = topology.mesh().nodes[static_cast<std::size_t>(high)];
  const Vec2& start = crossing.line.start;
  const Vec2 along = crossing.line.end - start;
  const double at_a = cross(along, a - start);
  const double at_b = cross(along, b - start);
  // Where the line runs nearly along the edge, rounding would spoil the quotient.
  const bool steep = std::abs(at_a - at_b) > 1e-4 * along.norm() * (b - a).norm();
  const double fraction = std::clamp(steep ? at_a / (at_a - at_b) : crossing_place(a, b, crossing.line), 0.0, 1.0);
  if (fraction <= kSnap) {
    crossing.snapped_to = low;
    crossing.point = a;
  } else if (fraction >= 1.0 - kSnap) {
    crossing.snapped_to = high;
    crossing.point = b;
  } else {
    crossing.point = a + fraction * (b - a);
    // Two segments that meet on the edge cross it at one point, not at two that rounding has set apart.
    if (!trace.crossings.empty()) {
      const EdgeCrossing& last = trace.crossings.back();
      if (last.edge == crossing.edge && (last.point - crossing.point).norm() <= kSamePoint * (b - a).norm())
        crossing.point = last.point;
    }
  }
  crossing.s = arc_length(crossing.point, segment);
  trace.crossings.push_back(crossing);
  return static_cast<int>(trace.crossings.size()) - 1;
}

void Tracer::walk(Trace& trace, Chain& chain, Passage passage, int segment) const {
  const Topology& topology = terrain_.topology;
  passage.first_kink = passage.last_kink = segment + 1;
  while (true) {
    const int local = leaving_edge(passage.element, line(segment), false);
    const Vec2 &a = topology.corner(passage.element, local), &b = topology.corner(passage.element, local + 1);
    if (shifted_side_of_edge(a, b, line(segment).end) > 0) {  // the segment ends in this triangle
      if (segment == last_segment()) break;
      ++segment;
      ++passage.last_kink;
      continue;
    }
    const TriangleEdge edge{passage.element, local};
    const TriangleEdge beyond = topology.across(edge);
    passage.out_edge = local;
    passage.out = add_crossing(trace, edge, segment, beyond.triangle == kNone);
    chain.passages.push_back(passage);
    if (beyond.triangle == kNone) return;
    passage = {.element = beyond.triangle,
               .in = passage.out,
               .in_edge = beyond.local,
               .first_kink = segment + 1,
               .last_kink = segment + 1};
  }
  chain.passages.push_back(passage);
}

Tracer::Exit Tracer::lead_out(Trace& trace, Index triangle, int end) const {
  const int segment = end == 0 ? 0 : last_segment();
  const TriangleEdge edge{triangle, leaving_edge(triangle, line(segment), end == 0)};
  return {add_crossing(trace, edge, segment, terrain_.topology.across(edge).triangle == kNone), edge.local};
}

// False, and nothing changes, if the line meets no boundary within an element's size.
bool Tracer::lead_to_boundary(Trace& trace, Chain& chain, int end) const {
  const Topology& topology = terrain_.topology;
  const int segment = end == 0 ? 0 : last_segment();
  const Vec2& nominal = end == 0 ? crack_.points.front() : crack_.points.back();
  const std::size_t crossings = trace.crossings.size();
  Chain longer = chain;
  const auto outermost = [&]() -> Passage& { return end == 0 ? longer.passages.front() : longer.passages.back(); };
  const double reach = topology.size(outermost().element);
  while (true) {
    Passage& passage = outermost();
    const Exit exit = lead_out(trace, passage.element, end);
    (end == 0 ? passage.in : passage.out) = exit.crossing;
    (end == 0 ? passage.in_edge : passage.out_edge) = exit.local_edge;
    const EdgeCrossing& crossing = trace.crossings[static_cast<std::size_t>(exit.crossing)];
    if ((crossing.point - nominal).norm() > reach) {
      trace.crossings.resize(crossings);
      return false;
    }
    if (crossing.on_boundary) break;
    const TriangleEdge beyond = topology.across({passage.element, exit.local_edge});
    Passage next{.element = beyond.triangle, .first_kink = segment + 1, .last_kink = segment + 1};
    (end == 0 ? next.out : next.in) = exit.crossing;
    (end == 0 ? next.out_edge : next.in_edge) = beyond.local;
    longer.passages.insert(end == 0 ? longer.passages.begin() : longer.passages.end(), next);
  }
  chain = std::move(longer);
  return true;
}

void Tracer::start_inside(Trace& trace, const EndPlace& place) const {
  Chain chain;
  walk(trace, chain, {.element = place.triangle}, 0);
  chain.kind[0] = place.at_boundary && lead_to_boundary(trace, chain, 0) ? CrackEnd::Kind::Mouth : CrackEnd::Kind::Tip;
  if (place.at_boundary && chain.kind[0] == CrackEnd::Kind::Tip && chain.passages.back().out >= 0) {
    // A crack that starts on the boundary and leaves at once has not begun yet.
    const double left_at = trace.crossings[static_cast<std::size_t>(chain.passages.back().out)].s;
    if (left_at - arc_at(0) < 1e-6 * terrain_.topology.size(place.triangle)) return;
  }
  trace.chains.push_back(std::move(chain));
}

void Tracer::finish(Trace& trace, const EndPlace& place) const {
  if (trace.chains.empty() || trace.chains.back().passages.back().out >= 0) return;
  Chain& chain = trace.chains.back();
  if (place.at_boundary) {
    if (lead_to_boundary(trace, chain, 1)) return;
    const Passage& first = chain.passages.front();
    const double entered_at = first.in < 0 ? arc_at(0) : trace.crossings[static_cast<std::size_t>(first.in)].s;
    if (arc_at(1) - entered_at < 1e-6 * terrain_.topology.size(place.triangle)) {
      trace.chains.pop_back();
      return;
    }
  }
  chain.kind[1] = CrackEnd::Kind::Tip;
}

std::vector<Tracer::Entry> Tracer::entries() const {
  const Topology& topology = terrain_.topology;
  std::vector<Entry> found;
  for (int segment = 0; segment <= last_segment(); ++segment) {
    const Line on = line(segment);
    std::vector<Index> near;
    terrain_.boundary_grid.near(on.start, on.end, [&](Index k) { near.push_back(k); });
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
    for (const Index k : near) {
      const TriangleEdge edge = terrain_.boundary[static_cast<std::size_t>(k)];
      const Vec2 &a = topology.corner(edge.triangle, edge.local), &b = topology.corner(edge.triangle, edge.local + 1);
      if (shifted_side_of_edge(a, b, on.start) > 0 || shifted_side_of_edge(a, b, on.end) < 0) continue;
      if (side_of_shifted_line(on.start, on.end, a) < 0 || side_of_shifted_line(on.start, on.end, b) > 0) continue;
      const double before = cross(b - a, on.start - a);
      const double after = cross(b - a, on.end - a);
      found.push_back({edge, segment, before == after ? 0.0 : before / (before - after)});
    }
  }
  std::stable_sort(found.begin(), found.end(), [](const Entry& a, const Entry& b) {
    return a.segment != b.segment ? a.segment < b.segment : a.along < b.along;
  });
  return found;
}

Trace Tracer::trace(const std::array<EndPlace, 2>& ends) {
  Trace trace;
  if (ends[0].triangle != kNone) start_inside(trace, ends[0]);
  for (const Entry& entry : entries()) {
    Chain chain;
    const int in = add_crossing(trace, entry.edge, entry.segment, true);
    walk(trace, chain, {.element = entry.edge.triangle, .in = in, .in_edge = entry.edge.local}, entry.segment);
    trace.chains.push_back(std::move(chain));
  }
  finish(trace, ends[1]);
  return trace;
}

}  // namespace cleft::geometry
