/// \file
/// A scene turned rigidly.
#pragma once

#include <string>

#include "cleft/problem/specification.hpp"

namespace cleft::objectivity {

/// Turns a vector counter-clockwise; exact for multiples of 90 degrees.
Mat2 rotation_matrix(double degrees);

/// The scene turned counter-clockwise about its origin: the nodes of its mesh, which is written to `mesh_file` (its
/// folder is made) in the format of Gmsh, its cracks, supports, tractions and gravity. Its solution is that of the
/// scene, turned. Throws InputError, located in the scene, on what cannot be turned:
///  - a boundary that prescribes one component alone, unless by a multiple of 90 degrees;
///  - a box of nodes if the box around them holds others after the turn;
///  - a registered field, and an exact solution.
problem::Specification turned(const problem::Specification& scene, double degrees, const std::string& mesh_file);

}  // namespace cleft::objectivity
