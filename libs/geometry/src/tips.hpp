/// \file
/// Tips inside triangles are moved to an edge.
#pragma once

#include <array>
#include <vector>

#include "trace.hpp"

namespace cleft::geometry {

/// Moves every tip of `trace` to the nearer crossing of its triangle: back to the edge by which the crack came, or on
/// along the crack's straight line to the edge by which that leaves. Distances that agree to 1e-9 of the triangle's
/// size move it back. A tip moved on to the boundary becomes a mouth. Chains that do not divide the body (of no length,
/// or along its boundary) are removed. Appends the nodes at which the jump must vanish to `tip_nodes`.
///
/// With a tip radius no tip is moved: its triangle leaves the chain, which so ends at the crossing by which the crack
/// enters it, and is listed in `trace.tips`.
///
/// Throws InputError (key = name of the crack) if nothing of the crack is left, or if the way on crosses the crack
/// itself.
void settle_tips(const Terrain& terrain, const Tracer& tracer, const Crack& crack, Trace& trace,
                 std::vector<Index>& tip_nodes);

/// The crack's points inside a passage's triangle. One as near to a node as a snapped crossing is moved onto it as
/// well, and one that lies on an edge onto its crossing.
std::vector<Vec2> kinks_of(const Topology& topology, const Trace& trace, const Crack& crack, const Passage& passage);

}  // namespace cleft::geometry
