#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <fmt/format.h>

#include <algorithm>

#include "cleft/geometry/delaunay.hpp"
#include "cleft/geometry/distance.hpp"

namespace cleft::geometry {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Polygon = CGAL::Polygon_2<Kernel>;

Polygon polygon_of(const Ring& ring) {
  Polygon out;
  for (const Vec2& p : ring.points) out.push_back({p.x(), p.y()});
  return out;
}

bool touch(const Polygon& a, const Polygon& b) {
  for (auto e = a.edges_begin(); e != a.edges_end(); ++e)
    for (auto f = b.edges_begin(); f != b.edges_end(); ++f)
      if (CGAL::do_intersect(*e, *f)) return true;
  return false;
}

bool holds(const Polygon& outer, const Polygon& inner) {
  return outer.bounded_side(*inner.vertices_begin()) == CGAL::ON_BOUNDED_SIDE;
}

std::string name_of_ring(std::size_t k) { return k == 0 ? "the outline" : fmt::format("hole {}", k); }

// Empty if a ring can be the boundary of a polygon.
std::string what_is_wrong(const Ring& ring) {
  if (ring.points.size() < 3) return "has fewer than three points";
  if (!std::ranges::all_of(ring.points, [](const Vec2& p) { return p.allFinite(); }))
    return "has a point that is not finite";
  return polygon_of(ring).is_simple() ? "" : "crosses or touches itself";
}

// Empty if ring `l`, which is listed before `k` and is the outline if it is the first, and hole `k` may be in one body.
std::string what_is_wrong(const std::vector<Polygon>& polygons, std::size_t l, std::size_t k) {
  const Polygon &before = polygons[l], &hole = polygons[k];
  if (touch(hole, before)) return fmt::format("{} and {} touch", name_of_ring(l), name_of_ring(k));
  if (l == 0 && !holds(before, hole)) return fmt::format("{} is outside of {}", name_of_ring(k), name_of_ring(l));
  if (l > 0 && (holds(before, hole) || holds(hole, before)))
    return fmt::format("{} is not apart from {}", name_of_ring(k), name_of_ring(l));
  return "";
}

}  // namespace

Outline box_outline(const std::array<double, 4>& box) {
  return {
      {{{box[0], box[1]}, {box[2], box[1]}, {box[2], box[3]}, {box[0], box[3]}}, {"bottom", "right", "top", "left"}},
      {}};
}

bool lies_inside(const Outline& outline, const Vec2& point) {
  constexpr double kAtBoundary = 1e-6;
  const auto extent_of = [](const Polygon& polygon) {
    const auto box = polygon.bbox();
    return std::max(box.xmax() - box.xmin(), box.ymax() - box.ymin());
  };
  const double near = kAtBoundary * extent_of(polygon_of(outline.outer));
  const auto side = [&](const Ring& ring) {
    for (std::size_t k = 0; k < ring.points.size(); ++k)
      if (distance_to_segment(ring.points[k], ring.points[(k + 1) % ring.points.size()], point) <= near)
        return CGAL::ON_BOUNDARY;
    return polygon_of(ring).bounded_side({point.x(), point.y()});
  };
  return side(outline.outer) == CGAL::ON_BOUNDED_SIDE &&
         std::ranges::all_of(outline.holes, [&](const Ring& hole) { return side(hole) == CGAL::ON_UNBOUNDED_SIDE; });
}

std::string what_is_wrong(const Outline& outline) {
  std::vector<Ring> rings = {outline.outer};
  rings.insert(rings.end(), outline.holes.begin(), outline.holes.end());
  std::vector<Polygon> polygons;
  for (std::size_t k = 0; k < rings.size(); ++k) {
    if (const auto problem = what_is_wrong(rings[k]); !problem.empty()) return name_of_ring(k) + ' ' + problem;
    polygons.push_back(polygon_of(rings[k]));
  }
  for (std::size_t k = 1; k < polygons.size(); ++k)
    for (std::size_t l = 0; l < k; ++l)
      if (auto problem = what_is_wrong(polygons, l, k); !problem.empty()) return problem;
  return "";
}

}  // namespace cleft::geometry
