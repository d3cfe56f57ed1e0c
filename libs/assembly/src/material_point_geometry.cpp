#include "cleft/assembly/material_point_geometry.hpp"

#include <algorithm>
#include <cassert>

namespace cleft::assembly {

namespace {

std::vector<std::array<Vec2, 3>> triangles_of(const Model& model, const enrichment::Cell& cell) {
  if (cell.cut == kNone) return {geometry::corners(model.mesh, cell.element)};
  return model.cut.elements[cell.cut].sub_triangles[static_cast<std::size_t>(cell.side)];
}

}  // namespace

std::vector<PointRange> points_by_triangle(const Model& model) {
  std::vector<PointRange> out(model.mesh.triangles.size(), {0, 0});
  for_each_material_point(model, [&](std::size_t p, const auto& point, double) {
    auto& [first, last] = out[point.element];
    if (last == 0) first = p;
    last = p + 1;
  });
  return out;
}

std::vector<Part> parts_of(const Model& model, const PointRange& points) {
  std::vector<Part> parts;
  std::size_t p = points.first;
  for (; p < std::min(points.last, model.cells.size()); ++p)
    parts.push_back({triangles_of(model, model.cells[p]), {p, p + 1}});
  if (p == points.last) return parts;
  for (const auto& [corners, count] :
       enrichment::tip_parts(model.mesh, model.cut, model.tip_points[p - model.cells.size()].element)) {
    parts.push_back({{corners}, {p, p + count}});
    p += count;
  }
  assert(p == points.last);
  return parts;
}

double area_within(const geometry::Disc& disc, const Model& model, Index point) {
  const auto whole = [&](Index element) { return geometry::area_within(disc, geometry::corners(model.mesh, element)); };
  const auto cells = static_cast<Index>(model.cells.size());
  if (point >= cells) {
    const auto& at = model.tip_points[point - cells];
    return at.weight * whole(at.element) / geometry::triangle_area(model.mesh, at.element);
  }
  double area = 0.0;
  for (const auto& part : triangles_of(model, model.cells[point])) area += geometry::area_within(disc, part);
  return area;
}

}  // namespace cleft::assembly
