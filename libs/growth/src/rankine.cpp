#include <algorithm>
#include <cmath>

#include "cleft/assembly/patches.hpp"
#include "cleft/assembly/stress.hpp"
#include "cleft/geometry/advance.hpp"
#include "cleft/growth/criterion.hpp"
#include "material_places.hpp"

namespace cleft::growth {
namespace {

// Calls visit(point, area) for the material points with an area within a radius of a tip. Returns whether the disc is
// larger than every triangle that it meets.
template <class Visit>
bool around(const assembly::Model& m, const TipName& tip, double radius, const Visit& visit) {
  const geometry::Disc disc{geometry::tip_of(m.cracks[tip.crack], tip.end).point, radius};
  double all = 0.0, largest = 0.0;
  assembly::for_each_material_point(m, [&](std::size_t p, const auto& point, double) {
    const double area = area_within(disc, m, static_cast<Index>(p));
    if (area == 0.0) return;
    all += area;
    largest = std::max(largest, geometry::triangle_area(m.mesh, point.element));
    visit(static_cast<Index>(p), area);
  });
  return all > largest;
}

struct Principal {
  double value = 0.0;  // the larger one
  Vec2 axis;
};

Principal largest_principal(const Mat2& s) {
  const double mean = 0.5 * (s(0, 0) + s(1, 1)), half = 0.5 * (s(0, 0) - s(1, 1)), shear = 0.5 * (s(0, 1) + s(1, 0));
  const double angle = 0.5 * std::atan2(shear, half);
  return {mean + std::hypot(half, shear), Vec2(std::cos(angle), std::sin(angle))};
}

}  // namespace

bool spans_elements(const assembly::Model& model, const TipName& tip, double radius) {
  return around(model, tip, radius, [](Index, double) {});
}

// theory (10.1), (10.2)
Demand Rankine::judge(const assembly::Equilibrium& body, const TipName& tip) const {
  const auto& m = body.model;
  double area = 0.0;
  Mat2 stress = Mat2::Zero(), deformation = Mat2::Zero();
  const bool spans = around(m, tip, radius, [&](Index p, double within) {
    const Mat2 F = assembly::material_deformation(m, p, body.displacement);
    const auto& remembered = body.plastic.empty() ? constitutive::PlasticState{} : body.plastic[p];
    area += within;
    stress += within * assembly::stress_of(m.material(p), F, remembered).in_plane;
    deformation += within * F;
  });
  Demand out;
  if (!spans) {
    out.measure = Demand::kUnknown;
    return out;
  }
  const Principal largest = largest_principal(stress / area);
  out.stress = largest.value;
  out.measure = largest.value / strength;
  const Vec2 pulled_back = m.is_small_strain() ? largest.axis : Vec2(deformation.transpose() * largest.axis);
  out.ahead = turn_left(pulled_back).normalized();
  if (out.ahead.dot(geometry::tip_of(m.cracks[tip.crack], tip.end).ahead) < 0.0) out.ahead = -out.ahead;
  return out;
}

}  // namespace cleft::growth
