#include "dead_loads.hpp"

#include <fmt/format.h>

#include <array>
#include <set>

#include "boundaries.hpp"
#include "exact.hpp"
#include "loads.hpp"
#include "meshing.hpp"

namespace cleft::problem {
namespace {

// The work of a traction on branch functions is not counted.
void refuse_ball(const Specification& specification, const TractionSpec& spec, const assembly::Model& m) {
  if (m.cut.tips.empty()) return;
  std::set<std::array<Index, 2>> edges;
  for (const auto& edge : m.mesh.boundaries.at(spec.on)) edges.insert(edge);
  for (std::size_t t = 0; t < m.mesh.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k)
      if (m.cut.tip_of_element[t] != kNone &&
          edges.contains({m.mesh.triangles[t][k], m.mesh.triangles[t][(k + 1) % 3]}))
        throw InputError(specification.formulation_at, specification.formulation_at.key("tip_enrichment"),
                         fmt::format("the ball of a tip reaches the boundary '{}', which carries a traction; allowed: "
                                     "a smaller radius",
                                     spec.on));
}

void add_traction(const Specification& specification, const TractionSpec& spec, assembly::Model& m) {
  require_boundary(m.mesh, spec.on, spec.at);
  refuse_ball(specification, spec, m);
  m.dead_loads.push_back([force = traction_force(m, spec.on, spec.value), a = spec.amplitude](double load) -> VecX {
    return a(load) * force;
  });
}

void add_gravity(const GravitySpec& gravity, assembly::Model& m) {
  const Vec2 density = gravity.density * gravity.value;
  const auto a = gravity.amplitude;
  const VecX force = body_force(m, [density](const Vec2&, geometry::MaybeSide) -> Vec2 { return density; });
  m.dead_loads.push_back([force, a](double load) -> VecX { return a(load) * force; });
  m.body_force = [density, a](double load) -> Vec2 { return a(load) * density; };
}

void add_loads_of_exact(const FieldSpec& exact, assembly::Model& m) {
  (void)make_field(exact, m.constants(0));  // its parameters are wrong now or not at all
  refuse_reversed_cracks(exact, m.cracks);
  add_loads_of(exact, m);
}

}  // namespace

void add_dead_loads(const Specification& specification, assembly::Model& m) {
  for (const auto& traction : specification.tractions) add_traction(specification, traction, m);
  if (specification.gravity) add_gravity(*specification.gravity, m);
  if (specification.exact) add_loads_of_exact(*specification.exact, m);
}

}  // namespace cleft::problem
