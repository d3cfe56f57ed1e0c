#include "cleft/geometry/delaunay.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Delaunay_mesh_vertex_base_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cleft/geometry/distance.hpp"
#include "cleft/support/error.hpp"

namespace cleft::geometry {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Delaunay_mesh_vertex_base_2<Kernel>;
using Face = CGAL::Delaunay_mesh_face_base_2<Kernel>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex, Face>>;
using Point = Kernel::Point_2;

constexpr double kMostNodes = 5e6;
constexpr double kSquaredSine = 0.125;  // of kLeastAngle, Shewchuk's bound for refinement to end

// Triangles are too large by a size field instead of one number: CGAL's own criterion with the bound set for each.
class Criteria : public CGAL::Delaunay_mesh_size_criteria_2<Triangulation> {
  using Base = CGAL::Delaunay_mesh_size_criteria_2<Triangulation>;

 public:
  explicit Criteria(const SizeField& size) : Base(kSquaredSine, 1.0), size_(&size) {}

  class Is_bad : public Base::Is_bad {
    using Plain = Base::Is_bad;

   public:
    Is_bad(const SizeField& size, const Kernel& kernel) : Plain(kSquaredSine, 1.0, kernel), size_(&size) {}
    using Plain::operator();

    CGAL::Mesh_2::Face_badness operator()(const Triangulation::Face_handle& face, Quality& quality) const {
      const auto p = [&](int k) { return Vec2(face->vertex(k)->point().x(), face->vertex(k)->point().y()); };
      const double allowed = (*size_)((p(0) + p(1) + p(2)) / 3.0);
      Plain(kSquaredSine, allowed, traits)(face, quality);
      return (*this)(quality);
    }

   private:
    const SizeField* size_;
  };

  Is_bad is_bad_object() const { return {*size_, traits}; }

 private:
  const SizeField* size_;
};

double length_of(const std::vector<Vec2>& line) {
  double length = 0.0;
  for (std::size_t k = 1; k < line.size(); ++k) length += (line[k] - line[k - 1]).norm();
  return length;
}

// Nodes that a size field asks for, about: an element of longest edge h covers h^2/3 on average.
double expected_nodes(const Outline& outline, const SizeField& size) {
  double twice_area = 0.0;
  const auto& p = outline.outer.points;
  for (std::size_t k = 0; k < p.size(); ++k) twice_area += cross(p[k] - p[0], p[(k + 1) % p.size()] - p[0]);
  double nodes = 0.75 * std::fabs(twice_area) / (size.far * size.far);
  for (const auto& source : size.sources)
    if (source.size < size.far) nodes += 3.0 * length_of(source.line) / (source.size * std::max(size.gradation, 1e-3));
  return nodes;
}

void check(const Outline& outline, const SizeField& size) {
  if (const auto problem = what_is_wrong(outline); !problem.empty())
    throw InputError({}, "outline", problem + "; allowed: simple polygons, holes inside the outline and apart");
  const auto usable = [](double h) { return h > 0.0 && std::isfinite(h); };
  bool all = usable(size.far) && usable(size.gradation);
  for (const auto& source : size.sources) all = all && usable(source.size) && !source.line.empty();
  if (!all) throw InputError({}, "size", "sizes and gradation must be positive");
  if (const double nodes = expected_nodes(outline, size); nodes > kMostNodes)
    throw InputError({}, "size",
                     fmt::format("asks for about {:.2g} nodes; allowed: at most {:.0e}", nodes, kMostNodes));
}

void insert(Triangulation& triangulation, const Ring& ring) {
  std::vector<Triangulation::Vertex_handle> corners;
  for (const Vec2& p : ring.points) corners.push_back(triangulation.insert({p.x(), p.y()}));
  for (std::size_t k = 0; k < corners.size(); ++k)
    triangulation.insert_constraint(corners[k], corners[(k + 1) % corners.size()]);
}

// A point inside each hole: the middle of its largest triangle, clear of the ring by far more than rounding.
std::vector<Point> seeds_of_holes(const Triangulation& triangulation, const Outline& outline) {
  std::vector<Point> seeds;
  for (const Ring& hole : outline.holes) {
    CGAL::Polygon_2<Kernel> polygon;
    for (const Vec2& p : hole.points) polygon.push_back({p.x(), p.y()});
    double most = 0.0;
    Point seed;
    for (auto f : triangulation.finite_face_handles()) {
      const Point middle = CGAL::centroid(triangulation.triangle(f));
      const double area = triangulation.triangle(f).area();
      if (area > most && polygon.bounded_side(middle) == CGAL::ON_BOUNDED_SIDE) {
        most = area;
        seed = middle;
      }
    }
    seeds.push_back(seed);
  }
  return seeds;
}

// Boundary edges belong to the edge of the outline that they lie on.
class Names {
 public:
  explicit Names(const Outline& outline) {
    add(outline.outer);
    for (const Ring& hole : outline.holes) add(hole);
  }

  const std::string& of(const Vec2& a, const Vec2& b) const {
    const Vec2 middle = 0.5 * (a + b);
    const auto off = [&](const Edge& e) { return distance_to_segment(e.start, e.end, middle); };
    return *std::min_element(edges_.begin(), edges_.end(), [&](const Edge& e, const Edge& f) {
              return off(e) < off(f);
            })->name;
  }

 private:
  struct Edge {
    Vec2 start, end;
    const std::string* name;
  };
  void add(const Ring& ring) {
    for (std::size_t k = 0; k < ring.points.size(); ++k)
      edges_.push_back({ring.points[k], ring.points[(k + 1) % ring.points.size()], &ring.names[k]});
  }
  std::vector<Edge> edges_;
};

Mesh mesh_of(const Triangulation& triangulation, const Outline& outline) {
  Mesh mesh;
  std::vector<Triangulation::Vertex_handle> vertices;
  for (auto v : triangulation.finite_vertex_handles()) vertices.push_back(v);
  std::sort(vertices.begin(), vertices.end(), [](const auto& a, const auto& b) {
    return std::pair(a->point().y(), a->point().x()) < std::pair(b->point().y(), b->point().x());
  });
  CGAL::Unique_hash_map<Triangulation::Vertex_handle, Index> number(kNone, vertices.size());
  for (const auto& v : vertices) {
    number[v] = static_cast<Index>(mesh.nodes.size());
    mesh.nodes.emplace_back(v->point().x(), v->point().y());
  }
  const Names names(outline);
  for (auto f : triangulation.finite_face_handles()) {
    if (!f->is_in_domain()) continue;
    std::array<Index, 3> t{number[f->vertex(0)], number[f->vertex(1)], number[f->vertex(2)]};
    for (int k = 0; k < 3; ++k)
      if (!f->neighbor(k)->is_in_domain()) {
        const Index a = t[(k + 1) % 3], b = t[(k + 2) % 3];
        mesh.boundaries[names.of(mesh.nodes[a], mesh.nodes[b])].push_back({a, b});
      }
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    mesh.triangles.push_back(t);
  }
  std::sort(mesh.triangles.begin(), mesh.triangles.end());
  for (auto& [name, edges] : mesh.boundaries) std::sort(edges.begin(), edges.end());
  return mesh;
}

}  // namespace

Mesh delaunay_mesh(const Outline& outline, const SizeField& size) {
  check(outline, size);
  Triangulation triangulation;
  insert(triangulation, outline.outer);
  for (const Ring& hole : outline.holes) insert(triangulation, hole);
  const auto seeds = seeds_of_holes(triangulation, outline);
  CGAL::Delaunay_mesher_2<Triangulation, Criteria> mesher(triangulation, Criteria(size));
  mesher.set_seeds(seeds.begin(), seeds.end());
  mesher.refine_mesh();
  return mesh_of(triangulation, outline);
}

}  // namespace cleft::geometry
