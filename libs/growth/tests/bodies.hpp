// Small bodies with cracks that grow.
#pragma once

#include <cmath>

#include "cleft/assembly/patches.hpp"
#include "cleft/geometry/delaunay.hpp"
#include "cleft/growth/evolution.hpp"

namespace cleft::growth::bodies {

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
  assembly::Material material = constitutive::Hencky{constitutive::lame(1e10, 0.25)};

  assembly::Model operator()(const std::vector<geometry::Crack>& grown) const {
    assembly::Model m;
    m.mesh = delaunay > 0.0 ? geometry::delaunay_mesh(geometry::box_outline({0, 0, 1, 1}), {delaunay, 0.25, {}})
                            : geometry::structured_mesh({0, 0, 1, 1}, cells, diagonal);
    m.cracks = grown;
    m.cut = geometry::cut(m.mesh, m.cracks);
    m.unknowns = enrichment::number_unknowns(m.mesh, m.cut);
    m.cells = enrichment::make_cells(m.mesh, m.cut, m.unknowns);
    if (!m.cut.tips.empty()) m.tip_points = enrichment::make_tip_points(m.mesh, m.cut, m.unknowns);
    m.ties = enrichment::make_ghost_ties(m.mesh, m.cut, m.unknowns, m.cells);
    m.materials = {material};
    if (f_bar) m.mate = assembly::pair_cells(m);
    auto& s = m.surfaces;
    s.faces = enrichment::make_faces(m.mesh, m.cut, m.unknowns);
    s.element_size = delaunay > 0.0 ? delaunay : 1.0 / cells[0];
    s.laws.assign(grown.size(), {1e10 / s.element_size, 1e10 / s.element_size, friction});
    s.sides.assign(grown.size(), contact::NegativeSide::Right);
    s.undeformed = m.is_small_strain();
    s.points = contact::place_points(s, 2);
    if (mortar) {
      s.mortar.assign(grown.size(), {true, 1.0, 1.0, 1e10 / s.element_size, s.element_size / 1e10});
      std::vector<contact::HatPlan> plan(s.faces.size());
      for (std::size_t f = 0; f < plan.size(); ++f)
        if (s.is_negative(s.faces[f])) plan[f].spacing = s.element_size;
      s.hats = contact::make_hats(s.faces, plan);
      s.first_multiplier = enrichment::add_multipliers(m.unknowns, static_cast<Index>(s.hats.nodes.size()));
    }
    const auto hold = [&](const char* on, const Vec2& at_full_load) {
      auto unknowns = geometry::boundary_nodes(m.mesh, on);
      for (std::size_t k = 0, nodes = unknowns.size(); k < nodes; ++k)
        if (m.unknowns.ghost[unknowns[k]] != kNone) unknowns.push_back(m.unknowns.ghost[unknowns[k]]);
      m.prescribed.push_back(
          {on, unknowns, {true, true}, [at_full_load, turn = turn](const Vec2& X, geometry::MaybeSide, double load) {
             return Vec2(rotation(turn * load) * (X + load * at_full_load) - X);
           }});
    };
    hold("bottom", {0, 0});
    hold("top", top);
    return m;
  }
  assembly::Model operator()() const { return (*this)(cracks); }

  Evolution evolution(const Law& law, int steps) const {
    std::vector<std::optional<Law>> laws(cracks.size());
    laws.front() = law;
    return {(*this)(), in_steps(steps), laws, *this};
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

}  // namespace cleft::growth::bodies
