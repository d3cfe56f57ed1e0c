/// \file
/// The way of one crack through a mesh.
#pragma once

#include <vector>

#include "cleft/geometry/cut.hpp"
#include "cleft/geometry/segment_grid.hpp"
#include "predicates.hpp"
#include "topology.hpp"

namespace cleft::geometry {

/// Points nearer to each other than this fraction of an edge are one and differ by rounding only.
inline constexpr double kSamePoint = 1e-12;

/// Where a crack crosses a mesh edge, once for both triangles of the edge.
struct EdgeCrossing {
  std::array<Index, 2> edge;  ///< its nodes, lower first
  Line line;                  ///< the crack segment
  Vec2 point;                 ///< metres, the node's own coordinates if snapped
  double s = 0.0;             ///< arc length along the crack, metres
  Index snapped_to = kNone;   ///< node
  bool on_boundary = false;
};

/// One crack inside one triangle, from edge to edge. Numbers of crossings are -1 where the crack ends inside.
struct Passage {
  Index element = kNone;
  int in = -1, out = -1;              ///< indices of crossings
  int in_edge = -1, out_edge = -1;    ///< local numbers of edges
  int first_kink = 0, last_kink = 0;  ///< the points [first_kink, last_kink) of the crack lie inside the triangle
};

/// Consecutive passages; the exit of one is the entry of the next.
struct Chain {
  std::vector<Passage> passages;
  std::array<CrackEnd::Kind, 2> kind{CrackEnd::Kind::Mouth, CrackEnd::Kind::Mouth};
};

/// A crack's end inside a triangle that keeps it, with the crossing by which the crack's straight line leads on.
struct TipPassage {
  int end;  ///< 0 the crack's first, 1 its last point
  Passage passage;
};

struct Trace {
  std::vector<EdgeCrossing> crossings;
  std::vector<Chain> chains;  ///< along the crack
  std::vector<TipPassage> tips;
};

/// Where an end of a crack lies, translated by (e, e^2).
struct EndPlace {
  Index triangle = kNone;    ///< kNone outside of the body
  bool at_boundary = false;  ///< within 1e-9 of the nearest boundary edge's length
};

/// A mesh made ready for following cracks.
struct Terrain {
  explicit Terrain(const Mesh& mesh);

  Topology topology;
  std::vector<TriangleEdge> boundary;
  SegmentGrid boundary_grid;  ///< over `boundary`
};

/// Places of the first and last point of every crack. One sweep over the mesh for all of them.
std::vector<std::array<EndPlace, 2>> locate_ends(const Terrain& terrain, const std::vector<Crack>& cracks);

/// Follows a crack from edge to edge. Ends at the boundary are led outward to it. Ends inside stay where they are: the
/// first passage then has no entry or the last no exit.
class Tracer {
 public:
  Tracer(const Terrain& terrain, const Crack& crack);

  Trace trace(const std::array<EndPlace, 2>& ends);

  /// The crack's straight line at its first (0) or last (1) point, led outward through the passage's triangle: the
  /// crossing and the edge by which it leaves.
  struct Exit {
    int crossing;
    int local_edge;
  };
  Exit lead_out(Trace& trace, Index triangle, int end) const;

  /// Arc length of `point`, which lies near segment `segment`; metres.
  double arc_length(const Vec2& point, int segment) const;
  /// Arc lengths of the first (0) and last (1) point, metres.
  double arc_at(int end) const { return end == 0 ? arc_.front() : arc_.back(); }

 private:
  Line line(int segment) const {
    return {crack_.points[static_cast<std::size_t>(segment)], crack_.points[static_cast<std::size_t>(segment) + 1]};
  }
  int last_segment() const { return static_cast<int>(crack_.points.size()) - 2; }
  int leaving_edge(Index triangle, const Line& line, bool backward) const;
  int add_crossing(Trace& trace, TriangleEdge edge, int segment, bool on_boundary) const;
  void walk(Trace& trace, Chain& chain, Passage passage, int segment) const;
  bool lead_to_boundary(Trace& trace, Chain& chain, int end) const;
  void start_inside(Trace& trace, const EndPlace& place) const;
  void finish(Trace& trace, const EndPlace& place) const;

  struct Entry {
    TriangleEdge edge;
    int segment;
    double along;  // fraction of the segment
  };
  std::vector<Entry> entries() const;

  const Terrain& terrain_;
  const Crack& crack_;
  std::vector<double> arc_;  // at every point
};

}  // namespace cleft::geometry
