/// \file
/// Where the material points of a model are.
#pragma once

#include <algorithm>

#include "cleft/assembly/model.hpp"
#include "cleft/geometry/disc.hpp"

namespace cleft::assembly {

/// What one material point stands for, or several in the ball of a tip: a triangle, one side of a cut one, or a
/// triangle of the quadrature in a ball.
struct Part {
  std::vector<std::array<Vec2, 3>> triangles;  ///< counter-clockwise, metres
  PointRange points;
};

/// Per triangle of the mesh its material points, which follow one another.
std::vector<PointRange> points_by_triangle(const Model& model);

/// The parts of one triangle, which fill it but for what is negligible (make_cells); from its points.
std::vector<Part> parts_of(const Model& model, const PointRange& points);

/// Area of what a material point stands for within a disc, m^2: exactly, for a triangle or one side of a cut one; of a
/// point in the ball of a tip as large a part as of its triangle.
double area_within(const geometry::Disc& disc, const Model& model, Index point);

/// Calls visit(point, area) for the material points with an area within a disc. Returns whether the disc is larger than
/// every triangle that it meets.
template <class Visit>
bool visit_within(const geometry::Disc& disc, const Model& model, const Visit& visit) {
  double all = 0.0, largest = 0.0;
  for_each_material_point(model, [&](std::size_t p, const auto& point, double) {
    const double area = area_within(disc, model, static_cast<Index>(p));
    if (area == 0.0) return;
    all += area;
    largest = std::max(largest, geometry::triangle_area(model.mesh, point.element));
    visit(static_cast<Index>(p), area);
  });
  return all > largest;
}

}  // namespace cleft::assembly
