/// \file
/// Meshes of Gmsh.
#pragma once

#include <string>

#include "cleft/geometry/mesh.hpp"

namespace cleft::geometry {
Mesh read_gmsh(const std::string& file);
}
