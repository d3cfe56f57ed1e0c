#include <algorithm>
#include <cmath>

#include "cleft/assembly/f_bar.hpp"
#include "cleft/assembly/material_point_geometry.hpp"
#include "cleft/assembly/stress.hpp"
#include "cleft/geometry/advance.hpp"
#include "cleft/growth/criterion.hpp"

namespace cleft::growth {
namespace {

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

// theory (10.1), (10.2)
Demand judge(const problem::Rankine& criterion, const assembly::Equilibrium& body, const TipName& tip) {
  const auto& m = body.model;
  double area = 0.0;
  Mat2 stress = Mat2::Zero(), deformation = Mat2::Zero();
  const geometry::Disc disc{geometry::tip_of(m.cracks[tip.crack], tip.end).point, criterion.radius};
  const bool spans = assembly::visit_within(disc, m, [&](Index p, double within) {
    const Mat2 F = assembly::material_deformation(m, p, body.displacement);
    const auto& state = body.plastic.empty() ? constitutive::PlasticState{} : body.plastic[p];
    area += within;
    stress += within * assembly::stress_of(m.material(p), F, state).in_plane;
    deformation += within * F;
  });
  Demand out;
  if (!spans) {
    out.ratio = Demand::kUnknown;
    return out;
  }
  const Principal largest = largest_principal(stress / area);
  out.stress = largest.value;
  out.ratio = largest.value / criterion.strength;
  const Vec2 pulled_back = m.is_small_strain() ? largest.axis : Vec2(deformation.transpose() * largest.axis);
  out.ahead = turn_left(pulled_back).normalized();
  if (out.ahead.dot(geometry::tip_of(m.cracks[tip.crack], tip.end).ahead) < 0.0) out.ahead = -out.ahead;
  return out;
}

}  // namespace cleft::growth
