#include "topology.hpp"

#include <algorithm>

namespace cleft::geometry {

Topology::Topology(const Mesh& mesh) : mesh_(mesh) {
  first_.assign(mesh.nodes.size() + 2, 0);
  // Counted two places ahead, so that filling moves every start to where it belongs.
  for (const auto& triangle : mesh.triangles) {
    for (const Index n : triangle) ++first_[static_cast<std::size_t>(n) + 2];
  }
  for (std::size_t n = 2; n < first_.size(); ++n) first_[n] += first_[n - 1];
  triangles_.resize(3 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const Index n : mesh.triangles[t]) {
      triangles_[static_cast<std::size_t>(first_[static_cast<std::size_t>(n) + 1]++)] = static_cast<Index>(t);
    }
  }
}

TriangleEdge Topology::across(TriangleEdge edge) const {
  const Index start = node(edge.triangle, edge.local);
  const Index end = node(edge.triangle, edge.local + 1);
  const auto n = static_cast<std::size_t>(start);
  for (Index k = first_[n]; k < first_[n + 1]; ++k) {
    const Index t = triangles_[static_cast<std::size_t>(k)];
    for (int local = 0; local < 3; ++local) {
      if (node(t, local) == end && node(t, local + 1) == start) return {t, local};
    }
  }
  return {};
}

std::vector<TriangleEdge> Topology::boundary() const {
  // Around an inner node the opposite edges close a ring, so any number given to nodes sums to zero over it, ends taken
  // against starts. That finds the nodes of the boundary in one cheap sweep; only edges between two such nodes are
  // looked up.
  const auto scrambled = [](Index n) {
    auto x = (static_cast<std::uint64_t>(n) + 1) * 0x9e3779b97f4a7c15U;
    x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9U;
    return x ^ (x >> 27U);
  };
  std::vector<std::uint64_t> ring(mesh_.nodes.size(), 0);
  for (const auto& triangle : mesh_.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      ring[static_cast<std::size_t>(triangle[k])] +=
          scrambled(triangle[(k + 2) % 3]) - scrambled(triangle[(k + 1) % 3]);
    }
  }
  std::vector<TriangleEdge> edges;
  for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
    const auto& triangle = mesh_.triangles[t];
    for (int k = 0; k < 3; ++k) {
      const auto at = [&](int local) {
        return ring[static_cast<std::size_t>(triangle[static_cast<std::size_t>(local % 3)])];
      };
      if (at(k) == 0 || at(k + 1) == 0) continue;
      const TriangleEdge edge{static_cast<Index>(t), k};
      if (across(edge).triangle == kNone) edges.push_back(edge);
    }
  }
  return edges;
}

double Topology::size(Index triangle) const {
  double longest = 0.0;
  for (int k = 0; k < 3; ++k) longest = std::max(longest, (corner(triangle, k + 1) - corner(triangle, k)).norm());
  return longest;
}

}  // namespace cleft::geometry
