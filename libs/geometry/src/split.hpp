/// \file
/// One triangle divided by the passages of a crack.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "trace.hpp"

namespace cleft::geometry {

/// A passage with its coordinates.
struct Path {
  int in_edge, out_edge;  ///< local numbers of the triangle's edges
  const EdgeCrossing *in, *out;
  std::vector<Vec2> kinks;  ///< between the two
};

struct Division {
  std::array<Side, 3> node_side{};
  std::array<double, 2> area{};
  std::array<std::vector<std::array<Vec2, 3>>, 2> sub_triangles;
};

/// Divides triangle `t` by paths that do not cross each other. Nothing if they do, or if a piece would lie on both
/// sides.
std::optional<Division> divide(const Mesh& mesh, Index t, const std::vector<Path>& paths);

}  // namespace cleft::geometry
