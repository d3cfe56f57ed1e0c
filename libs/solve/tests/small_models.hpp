// Small models that several tests use.
#pragma once

#include "cleft/problem/build.hpp"
#include "cleft/solve/stepping.hpp"

namespace cleft::solve::models {

/// Makes a model of its mesh and its cracks, elastic (Hencky, nu = 0.25) and with springs of `penalty_scale` E/h.
inline void discretise(assembly::Model& m, double penalty_scale, double friction, contact::NegativeSide side,
                       double young) {
  problem::Specification body;
  body.materials.emplace_back();
  body.materials.back().model = "hencky";
  body.materials.back().young = young;
  body.materials.back().poisson = 0.25;
  for (const auto& crack : m.cracks) {
    auto& spec = body.cracks.emplace_back();
    spec.name = crack.name;
    spec.law = contact::Coulomb{friction};
    spec.negative_side = side;
    spec.mortar.on = false;
    spec.normal_penalty = spec.tangential_penalty = penalty_scale * young / geometry::element_size(m.mesh, 0);
  }
  m.surfaces = {};
  auto prescribed = std::move(m.prescribed);
  m = problem::recut(body, m, m.cracks);
  m.prescribed = std::move(prescribed);
}

inline StepControls in_steps(int steps, std::vector<double> outputs = {}) {
  StepControls c;
  c.steps = steps;
  c.outputs = std::move(outputs);
  return c;
}

/// Contact by multipliers instead of springs, on all cracks.
inline void use_mortar(assembly::Model& m) {
  auto& s = m.surfaces;
  for (auto& springs : s.springs) {
    s.mortar.push_back({true, 1.0, 2.0, springs.normal, 1.0 / springs.normal});
    springs = {};
  }
  std::vector<contact::MultiplierSpacing> plan(s.faces.size());
  for (std::size_t f = 0; f < plan.size(); ++f) {
    const bool both = s.sides[s.faces[f].crack] == contact::NegativeSide::Both;
    if (s.is_negative(s.faces[f])) plan[f] = {s.element_size, both ? 0.5 : 1.0};
  }
  s.multiplier_space = contact::make_multiplier_space(s.faces, plan);
  s.first_multiplier = enrichment::add_multipliers(m.unknowns, static_cast<Index>(s.multiplier_space.nodes.size()));
}

inline assembly::Prescribed hold(const assembly::Model& m, const std::string& on, const Vec2& at_full_load) {
  return {on,
          geometry::boundary_nodes(m.mesh, on),
          {true, true},
          [at_full_load](const Vec2&, geometry::MaybeSide, double load) { return Vec2(load * at_full_load); }};
}

/// Plane-strain compression of a block with a 45-degree edge crack (Liu and Borja 2010, section 6.1).
inline assembly::Model block(int cells_across, contact::NegativeSide side,
                             geometry::Diagonal diagonal = geometry::Diagonal::Right) {
  assembly::Model m;
  m.mesh = geometry::structured_mesh({0, 0, 0.04, 0.08}, {cells_across, 2 * cells_across}, diagonal);
  m.cracks = {{"main", {{0.0, 0.01833}, {0.0349, 0.05323}}}};
  discretise(m, 1.0, 0.3, side, 1e10);
  m.prescribed = {hold(m, "bottom", {0, 0}), hold(m, "top", {-0.01, -0.01})};
  return m;
}

}  // namespace cleft::solve::models
