// The walk of a crack through the triangles of a mesh.
#pragma once

#include <optional>

#include "cleft/geometry/cut.hpp"

namespace cleft::geometry {

/// A crack's crossing with a mesh edge, in the walk of that crack.
struct Crossing {
  Index edge = kNone;
  double place = 0.0;   ///< on the edge, 0 at its lower-numbered node
  Index node = kNone;   ///< the node it was moved onto, or kNone
  Vec2 at;              ///< reference coordinates, metres
  double s = 0.0;       ///< arc length along the crack, metres
};

/// One passage through one triangle. No entry: the crack starts inside; no exit: it ends inside.
struct Visit {
  Index element = kNone;
  std::optional<Crossing> entry, exit;
  std::vector<Vec2> kinks;
  std::vector<double> kink_s;
};

/// A crack's passages in order, with its ends settled: tips moved to element edges, mouths clipped at the boundary.
struct Walk {
  std::vector<Visit> visits;
  std::array<CrackEnd, 2> ends;
  std::array<std::optional<Crossing>, 2> tips;  ///< where the jump must vanish
  int snapped = 0;
};

/// Throws InputError as `cut` says.
Walk walk(const Mesh& mesh, const Edges& edges, const Crack& crack);

}  // namespace cleft::geometry
