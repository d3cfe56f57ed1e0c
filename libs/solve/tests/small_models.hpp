// Small models that several tests use.
#pragma once

#include "cleft/solve/stepping.hpp"
#include "problem/tests/specifications.hpp"

namespace cleft::solve::models {

/// Makes a model of a mesh and cracks that the test has put there: elastic, with springs of `penalty_scale` E/h.
inline void discretise(assembly::Model& m, double penalty_scale, double friction, contact::NegativeSide side,
                       double young) {
  problem::Specification body;
  body.materials = {problem::small::elastic(young)};
  const double penalty = penalty_scale * young / geometry::element_size(m.mesh, 0);
  for (const auto& crack : m.cracks)
    body.cracks.push_back(problem::small::crack_with_springs(crack, friction, penalty, side));
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

inline assembly::Prescribed hold(const assembly::Model& m, const std::string& on, const Vec2& at_full_load) {
  return {on,
          geometry::boundary_nodes(m.mesh, on),
          {true, true},
          [at_full_load](const Vec2&, geometry::MaybeSide, double load) { return Vec2(load * at_full_load); }};
}

enum class Contact : std::uint8_t { Springs, Multipliers };

/// Plane-strain compression of a block with a 45-degree edge crack (Liu and Borja 2010, section 6.1).
inline assembly::Model block(int cells_across, contact::NegativeSide side,
                             geometry::Diagonal diagonal = geometry::Diagonal::Right,
                             Contact contact = Contact::Springs) {
  const geometry::Crack crack{"main", {{0.0, 0.01833}, {0.0349, 0.05323}}};
  const double penalty = problem::small::kYoung * cells_across / 0.04;
  const auto spec = contact == Contact::Springs ? problem::small::crack_with_springs(crack, 0.3, penalty, side)
                                                : problem::small::crack_with_multipliers(crack, 0.3, side);
  return problem::build_model(problem::small::block({cells_across, 2 * cells_across}, {-0.01, -0.01}, spec, diagonal));
}

}  // namespace cleft::solve::models
