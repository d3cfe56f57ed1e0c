#include "cleft/geometry/gmsh.hpp"

#include "cleft/support/error.hpp"
#include "targets.hpp"

namespace cleft::fuzz {

void gmsh(Bytes bytes) {
  try {
    const auto mesh = geometry::read_gmsh(file_of(bytes, ".msh"));
    require(!mesh.triangles.empty(), "a mesh has triangles");
    for (Index t = 0; t < static_cast<Index>(mesh.triangles.size()); ++t)
      require(geometry::triangle_area(mesh, t) > 0.0, "triangles are counter-clockwise");
  } catch (const InputError& error) {
    require(!error.problem().empty(), "an error says what is wrong");
  }
}

}  // namespace cleft::fuzz
