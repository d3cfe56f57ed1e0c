/// \file
/// What must hold for every cut, whatever mesh and cracks.
#pragma once

#include <string>
#include <vector>

#include "cleft/geometry/cut.hpp"

namespace cleft::geometry::test {

/// The first property that `cut` of `mesh` violates, in words; empty if it is sound.
std::string flaw(const Mesh& mesh, const std::vector<Crack>& cracks, const CutMesh& cut);

/// Length of the segments of crack `c`, metres.
double face_length(const CutMesh& cut, Index c);

/// A structured mesh of the unit square; inner nodes moved by up to `shake` of a cell at random.
Mesh shaken_mesh(std::array<int, 2> cells, Diagonal diagonal, double shake, unsigned seed);

/// The cut with all points in the opposite order.
Crack reversed(Crack crack);

/// Key and problem of the InputError that cutting throws, or empty strings.
std::array<std::string, 2> complaint(const Mesh& mesh, const std::vector<Crack>& cracks);

}  // namespace cleft::geometry::test
