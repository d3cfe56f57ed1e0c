#include <algorithm>

#include "cleft/geometry/distance.hpp"
#include "trace.hpp"

namespace cleft::geometry {

namespace {

bool contains(const Topology& topology, Index t, const Vec2& point) {
  for (int k = 0; k < 3; ++k) {
    if (shifted_side_of_edge(topology.corner(t, k), topology.corner(t, k + 1), point) < 0) return false;
  }
  return true;
}

}  // namespace

Terrain::Terrain(const Mesh& mesh) : topology(mesh), boundary(topology.boundary()) {
  std::vector<Vec2> starts, ends;
  for (const TriangleEdge& edge : boundary) {
    starts.push_back(topology.corner(edge.triangle, edge.local));
    ends.push_back(topology.corner(edge.triangle, edge.local + 1));
  }
  boundary_grid.build(starts, ends);
}

std::vector<std::array<EndPlace, 2>> locate_ends(const Terrain& terrain, const std::vector<Crack>& cracks) {
  const Topology& topology = terrain.topology;
  std::vector<Vec2> points;
  for (const Crack& crack : cracks) points.insert(points.end(), {crack.points.front(), crack.points.back()});
  std::vector<EndPlace> places(points.size());

  SegmentGrid grid;
  grid.build(points, points);
  for (Index t = 0; t < static_cast<Index>(topology.mesh().triangles.size()); ++t) {
    const Vec2 &a = topology.corner(t, 0), &b = topology.corner(t, 1), &c = topology.corner(t, 2);
    grid.near(a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c), [&](Index k) {
      const auto end = static_cast<std::size_t>(k);
      if (places[end].triangle == kNone && contains(topology, t, points[end])) places[end].triangle = t;
    });
  }

  double reach = 0.0;
  constexpr double kNear = 1e-9;
  for (const TriangleEdge& edge : terrain.boundary) reach = std::max(reach, kNear * topology.size(edge.triangle));
  const Vec2 around(reach, reach);
  for (std::size_t end = 0; end < points.size(); ++end) {
    terrain.boundary_grid.near(points[end] - around, points[end] + around, [&](Index k) {
      const auto [t, local] = terrain.boundary[static_cast<std::size_t>(k)];
      const Vec2 &a = topology.corner(t, local), &b = topology.corner(t, local + 1);
      if (distance_to_segment(a, b, points[end]) <= kNear * (b - a).norm()) places[end].at_boundary = true;
    });
  }

  std::vector<std::array<EndPlace, 2>> pairs;
  for (std::size_t c = 0; c < cracks.size(); ++c) pairs.push_back({places[2 * c], places[2 * c + 1]});
  return pairs;
}

}  // namespace cleft::geometry
