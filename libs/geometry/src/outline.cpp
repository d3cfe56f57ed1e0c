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
  std::vector<Polygon> polygons;
  const auto name = [](std::size_t k) { return k == 0 ? std::string("the outline") : fmt::format("hole {}", k); };
  const auto check = [&](const Ring& ring) -> std::string {
    const std::string who = name(polygons.size());
    if (ring.points.size() < 3) return who + " has fewer than three points";
    for (const Vec2& p : ring.points)
      if (!p.allFinite()) return who + " has a point that is not finite";
    polygons.push_back(polygon_of(ring));
    return polygons.back().is_simple() ? "" : who + " crosses or touches itself";
  };
  if (auto problem = check(outline.outer); !problem.empty()) return problem;
  for (const Ring& hole : outline.holes)
    if (auto problem = check(hole); !problem.empty()) return problem;
  for (std::size_t k = 1; k < polygons.size(); ++k)
    for (std::size_t l = 0; l < k; ++l) {
      if (touch(polygons[k], polygons[l])) return fmt::format("{} and {} touch", name(l), name(k));
      if (l == 0 ? !holds(polygons[0], polygons[k])
                 : holds(polygons[l], polygons[k]) || holds(polygons[k], polygons[l]))
        return fmt::format("{} is {} {}", name(k), l == 0 ? "outside of" : "not apart from", name(l));
    }
  return "";
}

}  // namespace cleft::geometry
