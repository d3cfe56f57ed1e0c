#include "cleft/problem/build.hpp"
#include "cleft/scene/read.hpp"
#include "cleft/support/error.hpp"
#include "targets.hpp"

namespace cleft::fuzz {
namespace {

// Delaunay meshes and those of files may be as large as they like: they are not built here.
bool is_small(const problem::Specification& scene) {
  const auto* mesh = std::get_if<problem::StructuredMesh>(&scene.mesh.kind);
  return mesh && mesh->cells[0] * static_cast<long>(mesh->cells[1]) <= 1000;
}

}  // namespace

void scene(Bytes bytes) {
  try {
    const auto scene = scene::read_scene(file_of(bytes, ".toml"));
    if (is_small(scene)) (void)problem::build_model(scene);
  } catch (const InputError& error) {
    require(!error.problem().empty(), "an error says what is wrong");
  }
}

}  // namespace cleft::fuzz
