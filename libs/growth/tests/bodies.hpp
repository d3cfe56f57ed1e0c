// Small bodies with cracks that grow.
#pragma once

#include <cmath>

#include "cleft/growth/evolution.hpp"
#include "problem/tests/specifications.hpp"

namespace cleft::growth {

using problem::GrowthLaw, problem::HoopStress, problem::Rankine;

namespace bodies {

inline solve::StepControls in_steps(int steps) {
  solve::StepControls controls;
  controls.steps = steps;
  return controls;
}

inline Mat2 rotation(double angle) {
  Mat2 R;
  R << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  return R;
}

/// A material and the kinematics that goes with it.
struct Solid {
  problem::MaterialSpec material;
  problem::Kinematics kinematics = problem::Kinematics::Finite;
};

inline Solid elastic(problem::Kinematics kinematics, double poisson = 0.25) {
  return {problem::small::elastic(problem::small::kYoung, poisson), kinematics};
}

/// Drucker and Prager's cone with E = 1e10 Pa, nu = 0.25, alpha = 5e7 Pa, hardening 1e9 Pa and beta = b = `slope`.
inline Solid cone(problem::Kinematics kinematics, double slope) {
  Solid out = elastic(kinematics);
  out.material.model = "drucker-prager";
  out.material.cohesion = 5e7;
  out.material.friction = out.material.dilatancy = slope;
  out.material.hardening = 1e9;
  return out;
}

/// A square of 1 m, Hencky with E = 1e10 Pa and nu = 0.25, whose bottom is held and whose top moves.
struct Square {
  std::vector<geometry::Crack> cracks;
  std::array<int, 2> cells{10, 10};
  geometry::Diagonal diagonal = geometry::Diagonal::Left;
  Vec2 top{0.0, 0.01};  ///< metres at full load
  double turn = 0.0;    ///< of all that is held, about the origin, on top of the rest; radians at full load
  double friction = 0.1;
  bool mortar = false;  ///< contact by multipliers instead of springs
  bool f_bar = false;
  double delaunay = 0.0;  ///< size of triangles, metres, of an unstructured mesh; 0: `cells`
  Solid solid = elastic(problem::Kinematics::Finite);
  const char* loaded = "";  ///< the part of the boundary that carries a traction, of nothing
  int max_iterations = problem::SolverSpec{}.max_iterations;

  problem::Specification specification(int steps) const {
    problem::Specification out;
    out.mesh.kind = mesh();
    out.materials = {solid.material};
    out.kinematics = solid.kinematics;
    out.f_bar = f_bar;
    for (const auto& crack : cracks) {
      out.cracks.push_back(interface(crack));
      out.tip_enrichment = std::max(out.tip_enrichment, crack.tip_radius);
    }
    out.boundaries = {held("bottom", {0.0, 0.0}), held("top", top)};
    if (*loaded != 0) {
      problem::TractionSpec traction;
      traction.on = loaded;
      out.tractions.push_back(traction);
    }
    out.loading.steps = steps;
    out.solver.max_iterations = max_iterations;
    return out;
  }

  assembly::Model operator()() const { return problem::build_model(specification(1)); }
  assembly::Model operator()(const std::vector<geometry::Crack>& grown) const {
    return problem::recut(specification(1), (*this)(), grown);
  }

  /// Whose cracks grow by these laws, one entry each. Laws that problem::build_model would refuse are allowed.
  Evolution evolution(const std::vector<std::optional<GrowthLaw>>& laws, int steps) const {
    auto out = specification(steps);
    for (std::size_t k = 0; k < laws.size(); ++k) out.cracks[k].growth = laws[k];
    return {out, (*this)()};
  }
  Evolution evolution(const GrowthLaw& law, int steps) const {
    return evolution(std::vector{std::optional(law)}, steps);
  }
  Evolution stationary(int steps) const { return {specification(steps), (*this)()}; }

 private:
  std::variant<problem::StructuredMesh, problem::DelaunayMesh, problem::GmshMesh> mesh() const {
    if (delaunay > 0.0) return problem::DelaunayMesh{geometry::box_outline({0, 0, 1, 1}), delaunay, delaunay, delaunay};
    return problem::StructuredMesh{{0, 0, 1, 1}, cells, diagonal, {}};
  }
  problem::CrackSpec interface(const geometry::Crack& crack) const {
    const double size = delaunay > 0.0 ? delaunay : 1.0 / cells[0];
    return mortar ? problem::small::crack_with_multipliers(crack, friction)
                  : problem::small::crack_with_springs(crack, friction, problem::small::kYoung / size);
  }
  problem::BoundarySpec held(const char* on, const Vec2& at_full_load) const {
    const auto out = problem::small::held(on, at_full_load);
    return turn == 0.0 ? out : problem::small::turned(out, turn);
  }
};

/// A crack from the left edge, level, that opens: it has one tip.
inline Square edge_crack() { return {.cracks = {{"main", {{0.0, 0.512}, {0.33, 0.512}}}}}; }

/// All steps to the end; stops where the run fails.
struct History {
  std::vector<Step> steps;
  std::optional<assembly::Failure> failure;
  std::vector<Advance> advances() const {
    std::vector<Advance> all;
    for (const auto& step : steps) all.insert(all.end(), step.advances.begin(), step.advances.end());
    return all;
  }
  std::vector<double> loads_of_growth() const {
    std::vector<double> loads;
    for (const auto& step : steps) loads.insert(loads.end(), step.advances.size(), step.load);
    return loads;
  }
};

inline History run(Evolution& body) {
  History out;
  while (!body.done()) {
    auto outcome = body.advance();
    if (auto* failure = std::get_if<assembly::Failure>(&outcome)) {
      out.failure = *failure;
      break;
    }
    out.steps.push_back(std::get<Step>(outcome));
  }
  return out;
}

}  // namespace bodies
}  // namespace cleft::growth
