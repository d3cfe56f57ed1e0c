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

}  // namespace cleft::growth
