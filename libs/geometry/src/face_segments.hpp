/// \file
/// A crack as segments from vertex to vertex.
#pragma once

#include "trace.hpp"

namespace cleft::geometry {

/// Appends the segments and ends of crack number `c`, and counts the snapped crossings. The balls of its tips must be
/// in `result` already: within them segments are divided so that the square roots of the distances to the tip, along
/// the crack, are spaced by at most a quarter of the square root of the size of the tip's triangle.
void add_segments(const Terrain& terrain, const Crack& crack, Index c, const Trace& trace, CutMesh& result);

}  // namespace cleft::geometry
