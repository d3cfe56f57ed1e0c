#include "meshing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ranges>

#include "cleft/geometry/gmsh.hpp"
#include "cleft/geometry/lines.hpp"

namespace cleft::problem {
namespace {

constexpr double kSineTolerance = 0.01;  // of the element size: how far the sampled curve may be from the sine

double smallest_element(const geometry::Mesh& mesh) {
  double out = element_size(mesh, 0);
  for (Index t = 1; t < static_cast<Index>(mesh.triangles.size()); ++t) out = std::min(out, element_size(mesh, t));
  return out;
}

// `size` is that of the elements.
std::vector<Vec2> points_of(const CrackSpec& spec, double size) {
  if (!spec.sine) return spec.points;
  try {
    return geometry::sine_curve(spec.sine->start, spec.sine->end, spec.sine->amplitude, spec.sine->periods,
                                kSineTolerance * size);
  } catch (const InputError&) {
    throw InputError(spec.at, spec.at.key("amplitude"),
                     "the curve is too long for this mesh; allowed: amplitudes and periods of the body's size");
  }
}

// What geometry finds wrong, by its own names of its arguments: keys of the mesh, or of a part of it (`part`, with a
// dot).
template <class Make>
auto located(const Location& at, const std::string& part, const Make& make) {
  try {
    return make();
  } catch (const InputError& error) {
    throw InputError(at, at.key(part + error.key()), error.problem());
  }
}

geometry::Mesh fill(const StructuredMesh& spec, const Specification& specification) {
  if (!spec.focus)
    return located(specification.mesh.at, "",
                   [&] { return geometry::structured_mesh(spec.box, spec.cells, spec.diagonal); });
  const auto lines = [&](int k) {
    const auto& box = spec.focus->box;
    return located(specification.mesh.at, "focus.", [&] {
      return geometry::graded_lines(spec.box[k], spec.box[k + 2], spec.cells[k],
                                    {box[k], box[k + 2], spec.focus->share});
    });
  };
  return geometry::mesh_of_lines(lines(0), lines(1), spec.diagonal);
}

geometry::Mesh fill(const DelaunayMesh& spec, const Specification& specification) {
  geometry::SizeField size{spec.size / spec.refine, spec.gradation, {}};
  const double along = spec.crack_size / spec.refine, at_tip = spec.tip_size / spec.refine;
  for (const auto& crack : specification.cracks) {
    const auto points = points_of(crack, along);
    size.sources.push_back({points, along});
    for (const Vec2& end : {points.front(), points.back()})
      if (geometry::lies_inside(spec.outline, end)) size.sources.push_back({{end}, at_tip});
  }
  return located(specification.mesh.at, "", [&] { return geometry::delaunay_mesh(spec.outline, size); });
}

using Box = std::array<Vec2, 2>;  // lower left and upper right corner

Box box_of(const StructuredMesh& spec) { return {Vec2(spec.box[0], spec.box[1]), Vec2(spec.box[2], spec.box[3])}; }

Box box_of(const DelaunayMesh& spec) {
  const auto& points = spec.outline.outer.points;
  Box out{points.front(), points.front()};
  for (const Vec2& point : points) out = {out[0].cwiseMin(point), out[1].cwiseMax(point)};
  return out;
}

// The coordinates come first, so that nothing is computed far from the origin.
template <class Spec>
MeshedSpecification make(const Spec& spec, const Specification& specification) {
  const auto [low, high] = box_of(spec);
  auto local = relative_to(local_origin(low, high), specification);
  auto mesh = fill(std::get<Spec>(local.specification.mesh.kind), local.specification);
  return {std::move(local), std::move(mesh)};
}

MeshedSpecification make(const GmshMesh& spec, const Specification& specification) {
  auto mesh = geometry::read_gmsh(spec.file);
  const auto [low, high] = geometry::box_around(mesh);
  auto local = relative_to(local_origin(low, high), specification);
  if (local.origin != Vec2::Zero())
    for (Vec2& node : mesh.nodes) node = count_from(local.origin, node);
  return {std::move(local), std::move(mesh)};
}

}  // namespace

MeshedSpecification make_mesh(const Specification& specification) {
  return std::visit([&](const auto& spec) { return make(spec, specification); }, specification.mesh.kind);
}

std::vector<geometry::Crack> make_cracks(const Specification& specification, const geometry::Mesh& mesh) {
  const double size = smallest_element(mesh);
  std::vector<geometry::Crack> cracks;
  for (const auto& crack : specification.cracks)
    cracks.push_back({crack.name, points_of(crack, size), specification.tip_enrichment});
  return cracks;
}

void require_boundary(const geometry::Mesh& mesh, const std::string& name, const Location& at) {
  if (mesh.boundaries.contains(name)) return;
  const std::string allowed = mesh.boundaries.empty()
                                  ? "the mesh has no named boundaries"
                                  : fmt::format("{}", fmt::join(mesh.boundaries | std::views::keys, ", "));
  throw InputError(at, at.key("on"), fmt::format("there is no boundary '{}'; allowed: {}", name, allowed));
}

}  // namespace cleft::problem
