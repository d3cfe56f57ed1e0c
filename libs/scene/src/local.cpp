#include "local.hpp"

#include <cmath>
#include <limits>

namespace cleft::scene {
namespace {

constexpr double kFar = 8.0;  // extents of the body: nearer, its coordinates have all digits but three bits

void shift(std::array<double, 4>& box, const Vec2& origin) {
  for (int k = 0; k < 4; ++k) box[k] -= origin[k % 2];
}

void shift(std::vector<Vec2>& points, const Vec2& origin) {
  for (Vec2& point : points) point -= origin;
}

void shift(StructuredMesh& mesh, const Vec2& origin) {
  shift(mesh.box, origin);
  if (mesh.focus) shift(mesh.focus->box, origin);
}

void shift(DelaunayMesh& mesh, const Vec2& origin) {
  shift(mesh.outline.outer.points, origin);
  for (auto& hole : mesh.outline.holes) shift(hole.points, origin);
}

void shift(GmshMesh& /*the file's nodes are no part of the scene*/, const Vec2& /*origin*/) {}

void shift(CrackSpec& crack, const Vec2& origin) {
  shift(crack.points, origin);
  if (!crack.sine) return;
  crack.sine->start -= origin;
  crack.sine->end -= origin;
}

// A box of nodes is as much wider as its decimals may be off those of the nodes.
void shift(BoundarySpec& boundary, const Vec2& origin) {
  if (boundary.rotation) boundary.rotation->center -= origin;
  if (!boundary.box) return;
  shift(*boundary.box, origin);
  for (int k = 0; k < 4; ++k)
    (*boundary.box)[k] += (k < 2 ? -2.0 : 2.0) * std::numeric_limits<double>::epsilon() * std::fabs(origin[k % 2]);
}

}  // namespace

// A power of two a thousand times smaller than the body divides the origin, so that it has few digits: as long as
// coordinates are multiples of their own last bit below that power, differences from it are, too.
Vec2 local_origin(const Vec2& low, const Vec2& high) {
  const double extent = (high - low).maxCoeff();
  if (!(std::max(low.cwiseAbs().maxCoeff(), high.cwiseAbs().maxCoeff()) > kFar * extent)) return Vec2::Zero();
  const double unit = std::exp2(std::floor(std::log2(extent)) - 10.0);
  return {unit * std::floor(low.x() / unit), unit * std::floor(low.y() / unit)};
}

LocalScene relative_to(const Vec2& origin, Scene scene) {
  if (origin == Vec2::Zero()) return {origin, std::move(scene)};
  std::visit([&](auto& mesh) { shift(mesh, origin); }, scene.mesh.kind);
  for (auto& crack : scene.cracks) shift(crack, origin);
  for (auto& boundary : scene.boundaries) shift(boundary, origin);
  return {origin, std::move(scene)};
}

}  // namespace cleft::scene
