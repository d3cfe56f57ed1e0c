/// \file
/// Unstructured meshes of polygons with holes, refined where a size field asks for it (CGAL's Delaunay refinement).
#pragma once

#include <string>
#include <vector>

#include "cleft/geometry/mesh.hpp"
#include "cleft/geometry/size_field.hpp"

namespace cleft::geometry {

/// A closed polygon; edge k runs from point k to the next and belongs to the boundary `names[k]`. Either sense.
struct Ring {
  std::vector<Vec2> points;  ///< metres
  std::vector<std::string> names;
};

/// A body: a polygon, and the holes in it.
struct Outline {
  Ring outer;
  std::vector<Ring> holes;
};

/// The box xmin, ymin, xmax, ymax (metres) with boundaries left, right, bottom, top.
Outline box_outline(const std::array<double, 4>& box);

/// What is wrong with the body, or empty: a ring with fewer than three points, or one that crosses or touches itself or
/// another, a hole outside of the outer ring or within another. By exact predicates.
std::string what_is_wrong(const Outline& outline);

/// Whether a point lies within the body and not on its boundary (up to 1e-6 of the body's extent).
bool lies_inside(const Outline& outline, const Vec2& point);

/// Smallest angle that refinement leaves, degrees, away from corners of the outline sharper than 60 degrees.
inline constexpr double kLeastAngle = 20.7;

/// A mesh whose edges are no longer than the size field allows at the middle of their triangles. The same input gives
/// the same mesh to the last bit; nodes are in order of y, then x. Throws InputError on an outline with something
/// wrong, on sizes that are not positive and finite, and where more than about 5e6 nodes are asked for.
Mesh delaunay_mesh(const Outline& outline, const SizeField& size);

}  // namespace cleft::geometry
