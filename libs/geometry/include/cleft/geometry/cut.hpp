/// \file
/// The cutter: which triangles a crack cuts, into which sides, along which segments.
///
/// Topology is decided by exact predicates on the crack translated by an infinitesimal (e, e^2), which leaves no
/// degenerate position: a crack through nodes or along edges falls on one well-defined side of them. Coordinates are
/// those of the real crack.
#pragma once

#include <array>
#include <vector>

#include "cleft/geometry/crack.hpp"
#include "cleft/geometry/mesh.hpp"
#include "cleft/geometry/tip.hpp"

namespace cleft::geometry {

/// A triangle that a crack divides. Arrays of two are indexed by Side. One side has area 0, and no sub-triangles, where
/// the crack runs along an edge or through a node only.
struct CutElement {
  Index element = kNone;
  Index crack = kNone;
  std::array<Side, 3> node_side{};                                ///< the side on which each of its nodes lies
  std::array<double, 2> area{};                                   ///< m^2; the two add up to the triangle's
  std::array<std::vector<std::array<Vec2, 3>>, 2> sub_triangles;  ///< counter-clockwise; their areas add up to `area`
};

/// The piece of a crack inside one triangle between two consecutive vertices (crossings with mesh edges and kinks),
/// along the crack's direction. Consecutive segments of a chain share their vertex to the last bit.
struct FaceSegment {
  Index cut = kNone;  ///< index into CutMesh::elements; none in a tip's own triangle, which is not divided
  Index crack = kNone;
  Vec2 start, end;       ///< reference coordinates, metres
  double s_start = 0.0;  ///< arc length along the crack (Crack::s_first at its first point), metres
  double s_end = 0.0;
  bool joins_previous = false;  ///< the previous entry of CutMesh::segments ends where this one starts
  Index tip = kNone;            ///< index into CutMesh::tips of the ball that it touches, or kNone
};

/// What became of one end of a crack.
struct CrackEnd {
  enum class Kind { Tip, Mouth } kind = Kind::Tip;  ///< inside the body, or at (or beyond) its boundary
  Vec2 nominal;                                     ///< the polyline's end
  Vec2 effective;  ///< where the cut really ends: on an element edge, on the boundary, or at a tip with a ball
  double s = 0.0;  ///< arc length of `effective` (beyond that of the nominal end where the tip was moved out)
};

struct CrackCut {
  Index first_segment = 0;  ///< its segments are [first_segment, last_segment) of CutMesh::segments
  Index last_segment = 0;
  std::array<CrackEnd, 2> ends;
};

/// A mesh cut by cracks.
struct CutMesh {
  std::vector<CutElement> elements;
  std::vector<Index> cut_of_element;  ///< per triangle: index into `elements`, or kNone
  std::vector<FaceSegment> segments;  ///< crack after crack, in each along its direction
  std::vector<CrackCut> cracks;
  std::vector<Index> tip_nodes;       ///< nodes at which the jump must vanish (never enriched), ascending
  std::vector<TipBall> tips;          ///< of the cracks with a tip radius, crack after crack
  std::vector<Index> tip_of_element;  ///< per triangle: index into `tips` of the ball it meets, or kNone; empty if none
  int snapped = 0;                    ///< crossings within `snap` edge lengths of a node, moved onto it
};

/// The number in CutMesh::tips of the ball at an end (0 first, 1 last) of a crack; kNone where there is none.
Index ball_at(const CutMesh& cut, Index crack, int end);

/// Crossings nearer to a node than this fraction of the edge are moved onto the node.
inline constexpr double kSnap = 1e-6;

/// Cuts `mesh` by `cracks`. Throws InputError (key = name of the crack) when a crack lies outside the body, is too
/// short to open any element, crosses itself or another crack, shares an element with another crack, or winds so
/// tightly that a node would lie on both of its sides.
///
/// Where a crack has a tip radius, its tips stay where they are, also inside a triangle: this triangle is not in
/// `elements`, the nodes of the edge by which the crack enters it are the tip nodes, and the segments near the tip are
/// graded. Throws InputError, too, where such a ball holds another crack or the other end of its own, overlaps or
/// shares a triangle with another ball, or where the crack within it does not lead away from the tip (within 84 degrees
/// of the radius at every point, and 90 degrees of its direction at the tip).
CutMesh cut(const Mesh& mesh, const std::vector<Crack>& cracks);

}  // namespace cleft::geometry
