#include "exact.hpp"

#include <cmath>
#include <memory>

#include "cleft/assembly/stress.hpp"
#include "cleft/problem/build.hpp"
#include "loads.hpp"

namespace cleft::problem {
namespace {

// Differences of fields are taken over this part of an element: their own error is then far below that of the elements.
constexpr double kStep = 1e-3;
double step_of(const assembly::Model& m) { return kStep * std::sqrt(2.0 * geometry::triangle_area(m.mesh, 0)); }

// A field times a load, in one material.
struct Manufactured {
  Field field;
  assembly::Material material;
  double load, step;

  Mat2 stress(const Vec2& X, geometry::MaybeSide side) const {
    return assembly::respond_from_rest(material, load * field_gradient(field, X, side, step)).piola;
  }

  Vec2 body_force(const Vec2& X, geometry::MaybeSide side) const {
    Vec2 divergence = Vec2::Zero();
    for (int j = 0; j < 2; ++j) {
      const auto at = [&](int steps) -> Vec2 { return stress(X + steps * step * Vec2::Unit(j), side).col(j); };
      divergence += (8.0 * (at(1) - at(-1)) - (at(2) - at(-2))) / (12.0 * step);
    }
    return -divergence;
  }
};

}  // namespace

void add_loads_of(const FieldSpec& spec, assembly::Model& model) {
  const FieldLoads loads = loads_of(spec);
  if (loads == FieldLoads::None) return;
  const Field field = make_field(spec, model.constants(0), model.origin);
  // mesh, cells and faces are what the integration needs
  const auto copy = std::make_shared<const assembly::Model>(model);
  model.dead_loads.emplace_back([copy, field, loads](double load) -> VecX {
    const Manufactured solution{field, copy->material(0), load, step_of(*copy)};
    VecX force =
        body_force(*copy, [&](const Vec2& X, geometry::MaybeSide side) { return solution.body_force(X, side); });
    if (loads == FieldLoads::BodyAndFaces)
      force += face_force(*copy, [&](const Vec2& X, geometry::Side side, const Vec2& outward) -> Vec2 {
        return solution.stress(X, side) * outward;
      });
    return force;
  });
}

ErrorNorms error_norms(const assembly::Model& m, const Field& exact, double factor, const VecX& displacement) {
  ErrorNorms out;
  const auto c = m.constants(0);
  const auto energy = [&](const Mat2& g) {
    const Mat2 e = 0.5 * (g + g.transpose());
    return c.lambda * e.trace() * e.trace() + 2.0 * c.mu * e.squaredNorm();
  };
  for_each_point(m, [&](const BulkPoint& at) {
    const Vec2 u = at.stencil.displacement(displacement), v = factor * exact(at.reference, at.side);
    const Mat2 g = factor * field_gradient(exact, at.reference, at.side, step_of(m));
    const Mat2 H = assembly::displacement_gradient(m, at.material_point, displacement);
    out.l2 += at.weight * (u - v).squaredNorm();
    out.l2_exact += at.weight * v.squaredNorm();
    out.energy += at.weight * energy(H - g);
    out.energy_exact += at.weight * energy(g);
  });
  for (double* value : {&out.l2, &out.energy, &out.l2_exact, &out.energy_exact}) *value = std::sqrt(*value);
  return out;
}

}  // namespace cleft::problem
