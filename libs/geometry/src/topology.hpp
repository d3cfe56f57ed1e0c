/// \file
/// Who is next to whom in a mesh: only what following a crack needs, at a fraction of the cost of all edges.
#pragma once

#include <vector>

#include "cleft/geometry/mesh.hpp"

namespace cleft::geometry {

/// Edge `local` of a triangle runs from its node `local` to the next one, body on the left.
struct TriangleEdge {
  Index triangle = kNone;
  int local = 0;
};

class Topology {
 public:
  /// Keeps a reference to `mesh`.
  explicit Topology(const Mesh& mesh);

  const Mesh& mesh() const { return mesh_; }
  Index node(Index triangle, int local) const {
    return mesh_.triangles[static_cast<std::size_t>(triangle)][static_cast<std::size_t>(local % 3)];
  }
  const Vec2& corner(Index triangle, int local) const {
    return mesh_.nodes[static_cast<std::size_t>(node(triangle, local))];
  }

  /// The same edge seen from the triangle beyond it; triangle kNone on the boundary.
  TriangleEdge across(TriangleEdge edge) const;

  /// All edges with a triangle on one side only.
  std::vector<TriangleEdge> boundary() const;

  /// Length of the longest edge, metres.
  double size(Index triangle) const;

 private:
  const Mesh& mesh_;
  std::vector<Index> first_;      // per node, start in triangles_
  std::vector<Index> triangles_;  // around a node
};

}  // namespace cleft::geometry
