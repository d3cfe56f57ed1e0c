#include "cleft/geometry/advance.hpp"

#include <algorithm>

#include "topology.hpp"

namespace cleft::geometry {

Vec2 reach(const Mesh& mesh, const Vec2& from, const Vec2& to) {
  const Vec2 way = to - from;
  double least = 1.0;
  for (const TriangleEdge& edge : Topology(mesh).boundary()) {
    const Vec2& a = mesh.nodes[static_cast<std::size_t>(
        mesh.triangles[static_cast<std::size_t>(edge.triangle)][static_cast<std::size_t>(edge.local)])];
    const Vec2& b = mesh.nodes[static_cast<std::size_t>(
        mesh.triangles[static_cast<std::size_t>(edge.triangle)][static_cast<std::size_t>((edge.local + 1) % 3)])];
    const double before = cross(b - a, from - a), after = cross(b - a, to - a);  // the body is on the left
    if (after > 0.0 || before <= 0.0) continue;
    if (cross(way, a - from) > 0.0 || cross(way, b - from) < 0.0) continue;
    least = std::min(least, before / (before - after));
  }
  return least < 1.0 ? Vec2(from + least * way) : to;
}

Crack extended(Crack crack, int end, const Vec2& point) {
  if (end == 1) {
    crack.points.push_back(point);
    return crack;
  }
  crack.s_first -= (crack.points.front() - point).norm();
  crack.points.insert(crack.points.begin(), point);
  return crack;
}

Tip tip_of(const Crack& crack, int end) {
  const auto& p = crack.points;
  const Vec2 &tip = end == 0 ? p.front() : p.back(), &behind = end == 0 ? p[1] : p[p.size() - 2];
  return {tip, (tip - behind).normalized()};
}

}  // namespace cleft::geometry
