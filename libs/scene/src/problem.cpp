#include "cleft/scene/problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "loads.hpp"

namespace cleft::scene {
namespace {

constexpr double kSineTolerance = 0.01;  // of the element size: how far the sampled curve may be from the sine

double element_size(const geometry::Mesh& mesh, Index t) { return std::sqrt(2.0 * geometry::triangle_area(mesh, t)); }

std::vector<geometry::Crack> make_cracks(const Scene& scene, const geometry::Mesh& mesh) {
  std::vector<geometry::Crack> cracks;
  for (const auto& spec : scene.cracks)
    cracks.push_back({spec.name, spec.sine
                                     ? geometry::sine_curve(spec.sine->start, spec.sine->end, spec.sine->amplitude,
                                                            spec.sine->periods, kSineTolerance * element_size(mesh, 0))
                                     : spec.points});
  return cracks;
}

geometry::CutMesh cut_located(const Scene& scene, const geometry::Mesh& mesh,
                              const std::vector<geometry::Crack>& cracks) {
  try {
    return geometry::cut(mesh, cracks);
  } catch (const InputError& error) {
    for (std::size_t k = 0; k < scene.cracks.size(); ++k)
      if (scene.cracks[k].name == error.key())
        throw InputError(scene.cracks[k].at, fmt::format("crack[{}] '{}'", k, error.key()), error.problem());
    throw;
  }
}

void set_up_contact(const Scene& scene, assembly::Model& m) {
  auto& s = m.surfaces;
  s.faces = enrichment::make_faces(m.mesh, m.cut, m.unknowns);
  s.search_radius = scene.solver.search_radius;
  for (const auto& element : m.cut.elements)
    s.element_size = std::max(s.element_size, element_size(m.mesh, element.element));
  const auto scale = penalty_scale(scene, m);
  for (std::size_t k = 0; k < scene.cracks.size(); ++k) {
    const auto& spec = scene.cracks[k];
    s.laws.push_back(
        {spec.normal_penalty.value_or(scale[k]), spec.tangential_penalty.value_or(scale[k]), spec.friction});
    s.sides.push_back(spec.negative_side);
  }
  s.points = contact::place_points(s, scene.solver.gauss_points);
}

// A node's unknowns on a boundary: its own, and its ghost where a crack crosses an edge of that boundary beside it.
std::vector<Index> boundary_unknowns(const assembly::Model& m, const std::string& on) {
  std::vector<Index> unknowns = geometry::boundary_nodes(m.mesh, on);
  std::map<Index, geometry::Side> side;
  for (const auto& element : m.cut.elements)
    for (int k = 0; k < 3; ++k) side[m.mesh.triangles[element.element][k]] = element.node_side[k];
  for (const auto& [a, b] : m.mesh.boundaries.at(on)) {
    const auto at_a = side.find(a), at_b = side.find(b);
    if (at_a == side.end() || at_b == side.end() || at_a->second == at_b->second) continue;
    for (const Index node : {a, b})
      if (m.unknowns.ghost[node] != kNone) unknowns.push_back(m.unknowns.ghost[node]);
  }
  std::sort(unknowns.begin(), unknowns.end());
  unknowns.erase(std::unique(unknowns.begin(), unknowns.end()), unknowns.end());
  return unknowns;
}

std::function<Vec2(const Vec2&, double)> displacement_of(const BoundarySpec& b, const constitutive::Lame& constants) {
  const Field field = b.field ? make_field(*b.field, constants) : Field{};
  return [b, field](const Vec2& X, double load) -> Vec2 {
    const double factor = b.amplitude(load);
    Vec2 u(b.ux.value_or(0.0), b.uy.value_or(0.0));
    if (b.affine) u = *b.affine * X;
    if (field) u = field(X);
    u *= factor;
    if (!b.rotation) return u;
    const double angle = b.rotation->degrees * b.rotation->amplitude(load) * std::numbers::pi / 180.0;
    Mat2 turn;
    turn << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
    const Vec2& c = b.rotation->center;
    return Vec2(turn * (X + u - c) + c - X);
  };
}

void refuse_contradictions(const Scene& scene, const assembly::Model& m) {
  constexpr double kTolerance = 1e-12;
  const Vec2 extent(scene.mesh.box[2] - scene.mesh.box[0], scene.mesh.box[3] - scene.mesh.box[1]);
  std::vector<Index> source(m.unknowns.components(), kNone);
  for (Index p = 0; p < static_cast<Index>(m.prescribed.size()); ++p)
    for (const Index unknown : m.prescribed[p].unknowns)
      for (int i = 0; i < 2; ++i) {
        Index& first = source[2 * unknown + i];
        if (!m.prescribed[p].component[i]) continue;
        if (first == kNone) {
          first = p;
          continue;
        }
        const Vec2& X = m.mesh.nodes[m.unknowns.node_of[unknown]];
        for (int k = 1; k <= 20; ++k) {
          const double load = k / 20.0;
          const double gap =
              std::fabs(m.prescribed[p].displacement(X, load)[i] - m.prescribed[first].displacement(X, load)[i]);
          if (gap > kTolerance * extent.norm())
            throw InputError(
                scene.boundaries[p].at, fmt::format("boundary[{}]", p),
                fmt::format("prescribes u{} at the node ({:.6g}, {:.6g}) unlike boundary[{}] '{}', by {:.3g} m at load "
                            "{}; allowed: equal values at shared nodes, or one component less",
                            i == 0 ? "x" : "y", X.x(), X.y(), first, scene.boundaries[first].name, gap, load));
        }
      }
}

// Density of the body force that makes `field` times the load a solution: -Div P(I + load grad u).
std::function<Vec2(const Vec2&)> source_of(const Field& field, const assembly::Material& material, double load,
                                           double step) {
  const auto stress = [field, material, load, step](const Vec2& X) -> Mat2 {
    const Mat2 F = Mat2::Identity() + load * field_gradient(field, X, step);
    return std::visit([&](const auto& law) { return law.respond(F).piola; }, material);
  };
  return [stress, step](const Vec2& X) -> Vec2 {
    Vec2 divergence = Vec2::Zero();
    for (int j = 0; j < 2; ++j) {
      const Vec2 d = step * Vec2::Unit(j);
      divergence +=
          (8.0 * (stress(X + d) - stress(X - d)) - (stress(X + 2 * d) - stress(X - 2 * d))).col(j) / (12.0 * step);
    }
    return -divergence;
  };
}

}  // namespace

std::vector<double> penalty_scale(const Scene& scene, const assembly::Model& model) {
  std::vector<double> size(scene.cracks.size(), 0.0);
  std::vector<int> count(scene.cracks.size(), 0);
  for (const auto& element : model.cut.elements) {
    size[element.crack] += element_size(model.mesh, element.element);
    ++count[element.crack];
  }
  for (std::size_t k = 0; k < size.size(); ++k) size[k] = scene.material.young * count[k] / size[k];
  return size;
}

assembly::Model build_model(const Scene& scene) {
  assembly::Model m;
  m.mesh = geometry::structured_mesh(scene.mesh.box, scene.mesh.cells, scene.mesh.diagonal);
  m.cracks = make_cracks(scene, m.mesh);
  m.cut = cut_located(scene, m.mesh, m.cracks);
  m.unknowns = enrichment::number_unknowns(m.mesh, m.cut);
  m.cells = enrichment::make_cells(m.mesh, m.cut, m.unknowns);
  const auto constants = constitutive::lame(scene.material.young, scene.material.poisson);
  if (scene.material.model == "hencky")
    m.material = constitutive::Hencky{constants};
  else
    m.material = constitutive::NeoHookean{constants};
  if (!scene.cracks.empty()) set_up_contact(scene, m);

  for (std::size_t k = 0; k < scene.boundaries.size(); ++k) {
    const auto& b = scene.boundaries[k];
    assembly::Prescribed p{b.name, b.box ? geometry::nodes_in_box(m.mesh, *b.box) : boundary_unknowns(m, b.on),
                           b.components(), displacement_of(b, constants)};
    if (p.unknowns.empty())
      throw InputError(b.at, fmt::format("boundary[{}].box", k),
                       "no node lies in the box; allowed: a box around at least one node");
    m.prescribed.push_back(std::move(p));
  }
  refuse_contradictions(scene, m);
  for (const auto& t : scene.tractions)
    m.dead_loads.push_back(
        [force = traction_force(m, t.on, t.value), a = t.amplitude](double load) -> VecX { return a(load) * force; });
  if (scene.gravity) {
    const Vec2 density = scene.gravity->density * scene.gravity->value;
    m.dead_loads.push_back([force = body_force(m,
                                               [density](const Vec2&) -> Vec2 {
                                                 return {density.x(), density.y()};
                                               }),
                            a = scene.gravity->amplitude](double load) -> VecX { return a(load) * force; });
  }
  if (scene.exact) {
    const Field field = make_field(*scene.exact, constants);
    const double step = 1e-3 * element_size(m.mesh, 0);
    // mesh and cells are what the integration needs; the loads of this copy are empty
    m.dead_loads.push_back([copy = m, field, step](double load) -> VecX {
      return body_force(copy, source_of(field, copy.material, load, step));
    });
  }
  return m;
}

assembly::StepControls step_controls(const Scene& scene) {
  assembly::StepControls c;
  c.steps = scene.loading.steps;
  c.outputs = scene.loading.outputs;
  c.min_step = scene.solver.min_step;
  c.newton = {scene.solver.residual_tolerance, scene.solver.correction_tolerance, scene.solver.min_iterations,
              scene.solver.max_iterations, scene.solver.extrapolate};
  return c;
}

ErrorNorms error_norms(const assembly::Model& m, const Field& exact, double factor, const VecX& displacement) {
  ErrorNorms out;
  const auto c = m.constants();
  const auto energy = [&](const Mat2& g) {
    const Mat2 e = 0.5 * (g + g.transpose());
    return c.lambda * e.trace() * e.trace() + 2.0 * c.mu * e.squaredNorm();
  };
  const double step = 1e-3 * element_size(m.mesh, 0);
  for_each_point(m, [&](const enrichment::Cell& cell, const Vec2& x, double weight) {
    const auto value = geometry::shape_values(m.mesh, cell.element, x);
    Vec2 u = Vec2::Zero();
    for (int k = 0; k < 3; ++k) u += value[k] * displacement.segment<2>(2 * cell.unknown[k]);
    const Vec2 v = factor * exact(x);
    const Mat2 g = factor * field_gradient(exact, x, step);
    out.l2 += weight * (u - v).squaredNorm();
    out.l2_exact += weight * v.squaredNorm();
    out.energy += weight * energy(cell.deformation(displacement) - Mat2::Identity() - g);
    out.energy_exact += weight * energy(g);
  });
  for (double* value : {&out.l2, &out.energy, &out.l2_exact, &out.energy_exact}) *value = std::sqrt(*value);
  return out;
}

}  // namespace cleft::scene
