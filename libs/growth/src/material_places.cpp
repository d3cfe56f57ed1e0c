#include "material_places.hpp"

namespace cleft::growth {

Vec2 place_of(const assembly::Model& model, Index point) {
  const assembly::MaterialPoint at = assembly::material_point(model, point);
  const auto cells = static_cast<Index>(model.cells.size());
  if (point >= cells || model.cells[point].cut == kNone) return at.reference;
  const auto& cell = model.cells[point];
  const auto& parts = model.cut.elements[cell.cut].sub_triangles[static_cast<std::size_t>(cell.side)];
  Vec2 moment = Vec2::Zero();
  double area = 0.0;
  for (const auto& [a, b, c] : parts) {
    const double part = cross(b - a, c - a);
    moment += part * (a + b + c) / 3.0;
    area += part;
  }
  return area > 0.0 ? Vec2(moment / area) : at.reference;
}

double area_within(const geometry::Disc& disc, const assembly::Model& model, Index point) {
  const auto whole = [&](Index element) { return geometry::area_within(disc, geometry::corners(model.mesh, element)); };
  const auto cells = static_cast<Index>(model.cells.size());
  if (point >= cells) {
    const auto& at = model.tip_points[point - cells];
    return at.weight * whole(at.element) / geometry::triangle_area(model.mesh, at.element);
  }
  const auto& cell = model.cells[point];
  if (cell.cut == kNone) return whole(cell.element);
  double area = 0.0;
  for (const auto& part : model.cut.elements[cell.cut].sub_triangles[static_cast<std::size_t>(cell.side)])
    area += geometry::area_within(disc, part);
  return area;
}

}  // namespace cleft::growth
