// Meshes and cracks of a scene.
#pragma once

#include "cleft/geometry/crack.hpp"
#include "local.hpp"

namespace cleft::problem {

/// A scene in the coordinates of its mesh.
struct MeshedSpecification {
  LocalSpecification local;
  geometry::Mesh mesh;
};

/// Throws InputError, located in the scene, where sizes ask for too many nodes or a file holds no mesh.
MeshedSpecification make_mesh(const Specification& specification);

/// Curves are sampled so finely that the polyline is within 0.01 of the smallest element of them.
std::vector<geometry::Crack> make_cracks(const Specification& specification, const geometry::Mesh& mesh);

/// Throws InputError unless the mesh has a boundary of this name.
void require_boundary(const geometry::Mesh& mesh, const std::string& name, const Location& at);

}  // namespace cleft::problem
