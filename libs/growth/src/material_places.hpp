// Where the material points of a model are.
#pragma once

#include "cleft/assembly/model.hpp"
#include "cleft/geometry/disc.hpp"

namespace cleft::growth {

/// What one material point stands for, or several in the ball of a tip: a triangle, one side of a cut one, or a
/// triangle of the quadrature in a ball.
struct Part {
  std::vector<std::array<Vec2, 3>> triangles;  ///< counter-clockwise, metres
  assembly::PointRange points;
};

/// Per triangle of the mesh its material points, which follow one another.
std::vector<assembly::PointRange> points_by_triangle(const assembly::Model& model);

/// The parts of one triangle, which fill it but for what is negligible (make_cells); from its points.
std::vector<Part> parts_of(const assembly::Model& model, const assembly::PointRange& points);

/// Area of what a material point stands for within a disc, m^2: exactly, for a triangle or one side of a cut one; of a
/// point in the ball of a tip as large a part as of its triangle.
double area_within(const geometry::Disc& disc, const assembly::Model& model, Index point);

}  // namespace cleft::growth
