#include "loads.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace cleft::problem {
namespace {

// Six points, exact to degree 4 (Strang and Fix 1973, rule 6).
struct TrianglePoint {
  double a, b, c, weight;
};
constexpr double kA = 0.445948490915965, kB = 0.091576213509771;
constexpr std::array<TrianglePoint, 6> kRule{{{kA, kA, 1 - 2 * kA, 0.223381589678011},
                                              {kA, 1 - 2 * kA, kA, 0.223381589678011},
                                              {1 - 2 * kA, kA, kA, 0.223381589678011},
                                              {kB, kB, 1 - 2 * kB, 0.109951743655322},
                                              {kB, 1 - 2 * kB, kB, 0.109951743655322},
                                              {1 - 2 * kB, kB, kB, 0.109951743655322}}};

constexpr double kGauss = 0.288675134594813;  // of the two points on [0, 1] from its middle, 1 / (2 sqrt 3)

// Where a crack crosses the edge from corner k to corner l of a cut triangle, 0 at k. A crack through the node of a
// corner leaves its side without area, and has no segment in the triangle.
double crossing_place(const assembly::Model& m, Index cut, int k, int l) {
  const auto& element = m.cut.elements[cut];
  if (element.area[static_cast<int>(element.node_side[k])] == 0.0) return 0.0;
  if (element.area[static_cast<int>(element.node_side[l])] == 0.0) return 1.0;
  const auto& t = m.mesh.triangles[element.element];
  const Vec2 a = m.mesh.nodes[t[k]], edge = m.mesh.nodes[t[l]] - a;
  double place = 0.5, nearest = std::numeric_limits<double>::infinity();
  const auto consider = [&](const Vec2& x) {
    const double along = std::clamp((x - a).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
    const double off = (a + along * edge - x).norm();
    if (off >= nearest) return;
    nearest = off;
    place = along;
  };
  for (const auto& s : m.cut.segments)
    if (s.cut == cut) {
      consider(s.start);
      consider(s.end);
    }
  return place;
}

}  // namespace

VecX traction_force(const assembly::Model& m, const std::string& boundary, const Vec2& traction) {
  VecX force = VecX::Zero(m.unknowns.components());
  std::map<std::array<Index, 2>, std::pair<Index, int>> owner;  // edge of a cut triangle -> cut element and corner
  for (Index c = 0; c < static_cast<Index>(m.cut.elements.size()); ++c)
    for (int k = 0; k < 3; ++k) {
      const auto& t = m.mesh.triangles[m.cut.elements[c].element];
      owner[{t[k], t[(k + 1) % 3]}] = {c, k};
    }
  for (const auto& [i, j] : m.mesh.boundaries.at(boundary)) {
    const Vec2 &a = m.mesh.nodes[i], &b = m.mesh.nodes[j];
    const double length = (b - a).norm();
    const auto add = [&](double from, double to, Index at_a, Index at_b) {
      const double on_b = 0.5 * (to * to - from * from), on_a = (to - from) - on_b;
      force.segment<2>(2 * at_a) += on_a * length * traction;
      force.segment<2>(2 * at_b) += on_b * length * traction;
    };
    const auto at = owner.find({i, j});
    const auto* element = at == owner.end() ? nullptr : &m.cut.elements[at->second.first];
    const int k = at == owner.end() ? 0 : at->second.second, l = (k + 1) % 3;
    if (!element || element->node_side[k] == element->node_side[l]) {
      add(0.0, 1.0, i, j);
      continue;
    }
    const double place = crossing_place(m, at->second.first, k, l);
    for (const auto& [from, to, side] :
         {std::tuple{0.0, place, element->node_side[k]}, std::tuple{place, 1.0, element->node_side[l]}})
      add(from, to, enrichment::side_unknown(m.unknowns, m.mesh, *element, k, side),
          enrichment::side_unknown(m.unknowns, m.mesh, *element, l, side));
  }
  return force;
}

void for_each_point(const assembly::Model& m, const std::function<void(const BulkPoint&)>& visit) {
  for (std::size_t c = 0; c < m.cells.size(); ++c) {
    const auto& cell = m.cells[c];
    BulkPoint point{static_cast<Index>(c), cell.side_if_cut(), {}, 0.0, {cell.unknown, std::array<double, 3>{}}};
    const auto on = [&](const std::array<Vec2, 3>& t) {
      const double area = 0.5 * cross(t[1] - t[0], t[2] - t[0]);
      for (const auto& q : kRule) {
        point.reference = q.a * t[0] + q.b * t[1] + q.c * t[2];
        point.weight = q.weight * area;
        point.stencil.weight = geometry::shape_values(m.mesh, cell.element, point.reference);
        visit(point);
      }
    };
    if (cell.cut == kNone) {
      const auto& t = m.mesh.triangles[cell.element];
      on({m.mesh.nodes[t[0]], m.mesh.nodes[t[1]], m.mesh.nodes[t[2]]});
    } else {
      for (const auto& t : m.cut.elements[cell.cut].sub_triangles[static_cast<int>(cell.side)]) on(t);
    }
  }
  for (std::size_t p = 0; p < m.tip_points.size(); ++p) {
    const auto& at = m.tip_points[p];
    visit({static_cast<Index>(m.cells.size() + p), at.side, at.reference, at.weight,
           enrichment::stencil_at(m.mesh, m.cut, m.unknowns, at.element, at.side, at.reference)});
  }
}

VecX body_force(const assembly::Model& m, const Density& density) {
  VecX force = VecX::Zero(m.unknowns.components());
  for_each_point(m, [&](const BulkPoint& at) {
    const Vec2 f = at.weight * density(at.reference, at.side);
    for (std::size_t k = 0; k < at.stencil.unknown.size(); ++k)
      force.segment<2>(2 * at.stencil.unknown[k]) += at.stencil.weight[k] * f;
  });
  return force;
}

VecX face_force(const assembly::Model& m, const FaceTraction& traction) {
  VecX force = VecX::Zero(m.unknowns.components());
  for (const auto& face : m.surfaces.faces) {
    const Vec2 along = face.reference_end - face.reference_start;
    const Vec2 outward = face.normal_sign() * turn_left(along.normalized());
    for (const double place : {0.5 - kGauss, 0.5 + kGauss}) {
      const Vec2 f = 0.5 * along.norm() * traction(face.reference_start + place * along, face.side, outward);
      for (std::size_t k = 0; k < face.start.unknown.size(); ++k) {
        const double weight = (1.0 - place) * face.start.weight[k] + place * face.end.weight[k];
        force.segment<2>(2 * face.start.unknown[k]) += weight * f;
      }
    }
  }
  return force;
}

std::vector<double> kinks_of(const Specification& specification) {
  std::vector<double> all;
  const auto add = [&](const Amplitude& amplitude) {
    const auto turns = amplitude.turns();
    all.insert(all.end(), turns.begin(), turns.end());
  };
  for (const auto& b : specification.boundaries) {
    add(b.amplitude);
    if (b.rotation) add(b.rotation->amplitude);
  }
  for (const auto& t : specification.tractions) add(t.amplitude);
  if (specification.gravity) add(specification.gravity->amplitude);
  std::sort(all.begin(), all.end());
  return all;
}

}  // namespace cleft::problem
