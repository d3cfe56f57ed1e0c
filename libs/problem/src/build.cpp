#include "cleft/problem/build.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <tuple>

#include "cleft/assembly/patches.hpp"
#include "cleft/problem/tip_reach.hpp"
#include "exact.hpp"
#include "loads.hpp"
#include "materials.hpp"
#include "meshing.hpp"
#include "supports.hpp"

namespace cleft::problem {
namespace {

geometry::CutMesh cut_located(const Specification& scene, const geometry::Mesh& mesh,
                              const std::vector<geometry::Crack>& cracks) {
  try {
    return geometry::cut(mesh, cracks);
  } catch (const geometry::CrackError& error) {
    const auto crack = std::ranges::find(scene.cracks, error.crack(), &CrackSpec::name);
    if (crack == scene.cracks.end()) throw;
    throw InputError(crack->at, crack->at.part("crack", crack->name), error.problem());
  }
}

double largest_poisson(const Specification& scene) {
  double out = 0.0;
  for (const auto& material : scene.materials) out = std::max(out, material.poisson);
  return out;
}

// Less smoothing than this is taken as this: where a crack has more hats than the elements along it let it open, what
// they cannot answer to is held at nothing by it, and else it is the compliance of a millionth of an element.
constexpr double kLeastSmoothing = 1e-6;

// Stiffness of both methods of contact: it is a property of the crack, and a later cut of the same crack keeps it.
struct ContactScales {
  std::vector<contact::Springs> springs;
  std::vector<contact::Mortar> mortar;
};

// Stiffness of mortar contact and its hats.
void set_up_hats(const Specification& scene, const std::vector<double>& scale, const ContactScales& earlier,
                 assembly::Model& m) {
  auto& s = m.surfaces;
  for (std::size_t k = 0; k < scene.cracks.size(); ++k) {
    auto mortar = scene.cracks[k].mortar;
    if (mortar.on) {
      mortar.scale = scale.empty() ? earlier.mortar[k].scale : scale[k] / (1.0 + largest_poisson(scene));
      mortar.compliance = 1.0 / mortar.scale;
      mortar.smoothing = std::max(mortar.smoothing, kLeastSmoothing);
    }
    s.mortar.push_back(mortar);
  }
  std::vector<contact::HatPlan> plan(s.faces.size());
  for (Index f = 0; f < static_cast<Index>(plan.size()); ++f) {
    const auto& face = s.faces[f];
    if (!s.is_mortar(face.crack) || !s.is_negative(face)) continue;
    const auto& segment = m.cut.segments[f / 2];
    const Index element = segment.cut == kNone ? m.cut.tips[segment.tip].element : m.cut.elements[segment.cut].element;
    plan[f] = {s.mortar[face.crack].hat_width * element_size(m.mesh, element),
               s.sides[face.crack] == contact::NegativeSide::Both ? 0.5 : 1.0};
  }
  s.hats = contact::make_hats(s.faces, plan);
  s.first_multiplier = enrichment::add_multipliers(m.unknowns, static_cast<Index>(s.hats.nodes.size()));
}

// None with mortar contact.
contact::Springs springs_of(const CrackSpec& spec, double scale) {
  if (spec.mortar.on) return {};
  return {spec.normal_penalty.value_or(scale), spec.tangential_penalty.value_or(scale)};
}

// With the stiffness of an earlier cut of the same cracks, where there is one.
void set_up_contact(const Specification& scene, const ContactScales& earlier, assembly::Model& m) {
  auto& s = m.surfaces;
  s.faces = enrichment::make_faces(m.mesh, m.cut, m.unknowns);
  s.search_radius = scene.solver.search_radius;
  s.undeformed = scene.kinematics == Kinematics::Small;
  for (const auto& element : m.cut.elements)
    s.element_size = std::max(s.element_size, element_size(m.mesh, element.element));
  s.springs = earlier.springs;
  const auto scale = s.springs.empty() ? penalty_scale(scene, m) : std::vector<double>{};
  for (std::size_t k = 0; k < scene.cracks.size(); ++k) {
    const auto& spec = scene.cracks[k];
    s.laws.push_back(contact::Coulomb{spec.friction});
    if (!scale.empty()) s.springs.push_back(springs_of(spec, scale[k]));
    s.sides.push_back(spec.negative_side);
  }
  s.points = contact::place_points(s, scene.solver.gauss_points);
  if (std::ranges::any_of(scene.cracks, [](const CrackSpec& crack) { return crack.mortar.on; }))
    set_up_hats(scene, scale, earlier, m);
}

// The unknowns of nodes whose displacement is prescribed: their own, and the ghosts of two that a crack divides.
std::vector<Index> prescribed_unknowns(const assembly::Model& m, std::vector<Index> unknowns) {
  std::vector<bool> held(m.mesh.nodes.size(), false);
  for (const Index node : unknowns) held[node] = true;
  for (const auto& element : m.cut.elements)
    for (int k = 0; k < 3; ++k) {
      const int l = (k + 1) % 3;
      const auto& corner = m.mesh.triangles[element.element];
      if (!held[corner[k]] || !held[corner[l]] || element.node_side[k] == element.node_side[l]) continue;
      for (const Index node : {corner[k], corner[l]})
        if (m.unknowns.ghost[node] != kNone) unknowns.push_back(m.unknowns.ghost[node]);
    }
  std::sort(unknowns.begin(), unknowns.end());
  unknowns.erase(std::unique(unknowns.begin(), unknowns.end()), unknowns.end());
  return unknowns;
}

std::function<Vec2(const Vec2&, geometry::MaybeSide, double)> displacement_of(const BoundarySpec& b,
                                                                              const constitutive::Lame& constants,
                                                                              const Vec2& origin) {
  const Field field = b.field ? make_field(*b.field, constants, origin) : Field{};
  const Vec2 far = b.affine ? Vec2(*b.affine * origin) : Vec2::Zero();
  return [b, field, far](const Vec2& X, geometry::MaybeSide side, double load) -> Vec2 {
    const double factor = b.amplitude(load);
    Vec2 u(b.ux.value_or(0.0), b.uy.value_or(0.0));
    if (b.affine) u = *b.affine * X + far;
    if (field) u = field(X, side);
    u *= factor;
    if (!b.rotation) return u;
    const double angle = b.rotation->degrees * b.rotation->amplitude(load) * std::numbers::pi / 180.0;
    Mat2 turn;
    turn << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
    const Vec2& c = b.rotation->center;
    return Vec2(turn * (X + u - c) + c - X);
  };
}

// The sides of a field are those of a crack along its direction; one that runs the other way would swap them.
void refuse_reversed_cracks(const FieldSpec& spec, const std::vector<geometry::Crack>& cracks) {
  const auto direction = crack_direction_of(spec);
  if (!direction) return;
  for (const auto& crack : cracks)
    if ((crack.points.back() - crack.points.front()).dot(*direction) < 0.0)
      throw InputError(
          spec.at, "field.angle",
          fmt::format("crack '{}' runs against the direction of field '{}', whose left would be its right; "
                      "allowed: the crack's points, and its negative side, the other way round",
                      crack.name, spec.name));
}

// The work of a traction on branch functions is not counted.
void refuse_ball(const TractionSpec& spec, const assembly::Model& m) {
  if (m.cut.tips.empty()) return;
  std::set<std::array<Index, 2>> edges;
  for (const auto& edge : m.mesh.boundaries.at(spec.on)) edges.insert(edge);
  for (std::size_t t = 0; t < m.mesh.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k)
      if (m.cut.tip_of_element[t] != kNone &&
          edges.contains({m.mesh.triangles[t][k], m.mesh.triangles[t][(k + 1) % 3]}))
        throw InputError(spec.at, "formulation.tip_enrichment",
                         fmt::format("the ball of a tip reaches the boundary '{}', which carries a traction; allowed: "
                                     "a smaller radius",
                                     spec.on));
}

// Where two boundaries could differ most: between the points of their amplitudes both are linear, but for rotations.
std::vector<double> loads_to_compare(const BoundarySpec& a, const BoundarySpec& b) {
  std::vector<double> loads;
  for (int k = 20; k >= 1; --k) loads.push_back(k / 20.0);  // at full load values are those of the scene
  const auto add = [&](const Amplitude& amplitude) {
    for (const auto& [load, factor] : amplitude.points)
      if (load > 0.0 && load < 1.0) loads.push_back(load);
  };
  for (const auto* boundary : {&a, &b}) {
    add(boundary->amplitude);
    if (boundary->rotation) add(boundary->rotation->amplitude);
  }
  return loads;
}

void refuse_contradictions(const Specification& scene, const assembly::Model& m) {
  constexpr double kTolerance = 1e-12;
  const auto [low, high] = geometry::box_around(m.mesh);
  const double extent = (high - low).norm();
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
        for (const double load : loads_to_compare(scene.boundaries[p], scene.boundaries[first])) {
          const double value = assembly::prescribed_value(m, m.prescribed[p], unknown, load)[i],
                       other = assembly::prescribed_value(m, m.prescribed[first], unknown, load)[i];
          if (std::fabs(value - other) > kTolerance * extent)
            throw InputError(
                scene.boundaries[p].at, fmt::format("boundary[{}] '{}'", p, scene.boundaries[p].name),
                fmt::format("prescribes u{0} = {1:.10g} m at the node {2} at load {3:.6g}, where "
                            "boundary[{4}] '{5}' prescribes u{0} = {6:.10g} m; allowed: equal values at shared "
                            "nodes, or u{0} on one of the two only",
                            i == 0 ? "x" : "y", value, m.words_for(X), load, first, scene.boundaries[first].name,
                            other));
        }
      }
}

// Of the elements that each crack cuts: the sum of their sizes, metres, and how many they are.
std::vector<std::pair<double, int>> summed_sizes(const assembly::Model& model) {
  std::vector<std::pair<double, int>> out(model.cracks.size());
  for (const auto& element : model.cut.elements) {
    out[element.crack].first += element_size(model.mesh, element.element);
    ++out[element.crack].second;
  }
  return out;
}

}  // namespace

std::vector<double> cut_sizes(const assembly::Model& model) {
  std::vector<double> out;
  for (const auto& [sum, count] : summed_sizes(model)) out.push_back(sum / count);
  return out;
}

std::vector<double> penalty_scale(const Specification& scene, const assembly::Model& model) {
  constexpr double kNoSide = std::numeric_limits<double>::infinity();
  std::vector<double> out(scene.cracks.size(), kNoSide);
  assembly::for_each_material_point(model, [&](std::size_t p, const auto& point, double) {
    const Index cut = model.cut.cut_of_element[point.element];
    if (cut == kNone) return;
    double& softest = out[model.cut.elements[cut].crack];
    softest = std::min(softest, scene.materials[model.material_of.empty() ? 0 : model.material_of[p]].young);
  });
  const auto sizes = summed_sizes(model);
  for (std::size_t k = 0; k < out.size(); ++k) out[k] = out[k] * sizes[k].second / sizes[k].first;
  return out;
}

namespace {

// What grows needs a tip, and averages around it something to average over.
void refuse_idle_growth(const Specification& scene, const assembly::Model& m) {
  for (Index c = 0; c < static_cast<Index>(scene.cracks.size()); ++c) {
    const auto& [law, at] = std::tie(scene.cracks[c].growth, scene.cracks[c].growth_at);
    if (!law) continue;
    const auto* rankine = std::get_if<Rankine>(&law->criterion);
    int tips = 0;
    for (const int end : {0, 1}) {
      if (!law->tips[end] || m.cut.cracks[c].ends[end].kind != geometry::CrackEnd::Kind::Tip) continue;
      ++tips;
      if (rankine && !spans_elements(m, c, end, rankine->radius))
        throw InputError(
            at, fmt::format("crack[{}].growth.radius", c),
            "the disc of this radius around a tip is smaller than an element; allowed: a larger radius, or a "
            "finer mesh");
    }
    if (tips == 0)
      throw InputError(at, fmt::format("crack[{}].growth.tips", c),
                       "none of these ends lies inside the body; allowed: growth of a crack with a tip, and tips that "
                       "name it");
  }
}

assembly::Model discretise(const LocalSpecification& local, geometry::Mesh mesh, std::vector<geometry::Crack> cracks,
                           const ContactScales& earlier) {
  const Specification& scene = local.scene;
  assembly::Model m;
  m.origin = local.origin;
  m.mesh = std::move(mesh);
  m.cracks = std::move(cracks);
  m.cut = cut_located(scene, m.mesh, m.cracks);
  m.unknowns = enrichment::number_unknowns(m.mesh, m.cut);
  if (scene.kinematics == Kinematics::Finite) m.unknowns.blunting = enrichment::kBlunting;
  m.cells = enrichment::make_cells(m.mesh, m.cut, m.unknowns);
  if (!m.cut.tips.empty()) m.tip_points = enrichment::make_tip_points(m.mesh, m.cut, m.unknowns);
  m.ties = enrichment::make_ghost_ties(m.mesh, m.cut, m.unknowns, m.cells);
  fill_with_materials(scene, m);
  const auto constants = m.constants(0);  // a field is only allowed where it is the only one
  if (scene.f_bar) m.mate = assembly::pair_cells(m);
  if (!scene.cracks.empty()) set_up_contact(scene, earlier, m);

  for (std::size_t k = 0; k < scene.boundaries.size(); ++k) {
    const auto& b = scene.boundaries[k];
    if (b.field) refuse_reversed_cracks(*b.field, m.cracks);
    if (!b.box) require_boundary(m.mesh, b.on, b.at, fmt::format("boundary[{}].on", k));
    auto nodes = b.box ? geometry::nodes_in_box(m.mesh, *b.box) : geometry::boundary_nodes(m.mesh, b.on);
    assembly::Prescribed p{b.name, prescribed_unknowns(m, std::move(nodes)), b.components(),
                           displacement_of(b, constants, m.origin)};
    if (p.unknowns.empty())
      throw InputError(b.at, fmt::format("boundary[{}].box", k),
                       "no node lies in the box; allowed: a box around at least one node");
    m.prescribed.push_back(std::move(p));
  }
  refuse_contradictions(scene, m);
  // who builds a model on a scene without boundaries prescribes by other means
  if (const auto free = scene.boundaries.empty() ? std::nullopt : free_motion(m))
    throw InputError(scene.boundaries.back().at, "boundary",
                     *free + "; allowed: boundaries that together hold every part in x, in y and against turning");
  for (std::size_t k = 0; k < scene.tractions.size(); ++k) {
    require_boundary(m.mesh, scene.tractions[k].on, scene.tractions[k].at, fmt::format("traction[{}].on", k));
    refuse_ball(scene.tractions[k], m);
  }
  for (const auto& t : scene.tractions)
    m.dead_loads.push_back(
        [force = traction_force(m, t.on, t.value), a = t.amplitude](double load) -> VecX { return a(load) * force; });
  if (scene.gravity) {
    const Vec2 density = scene.gravity->density * scene.gravity->value;
    const auto a = scene.gravity->amplitude;
    const VecX force = body_force(m, [density](const Vec2&, geometry::MaybeSide) -> Vec2 { return density; });
    m.dead_loads.push_back([force, a](double load) -> VecX { return a(load) * force; });
    m.body_force = [density, a](double load) -> Vec2 { return a(load) * density; };
  }
  if (scene.exact) {
    (void)make_field(*scene.exact, constants);  // its parameters are wrong now or not at all
    refuse_reversed_cracks(*scene.exact, m.cracks);
    add_loads_of(*scene.exact, m);
  }
  return m;
}

}  // namespace

assembly::Model build_model(const Specification& scene) {
  auto [local, mesh] = make_mesh(scene);
  auto cracks = make_cracks(local.scene, mesh);
  auto m = discretise(local, std::move(mesh), std::move(cracks), {});
  refuse_idle_growth(scene, m);
  refuse_narrow_tips(scene, m);
  return m;
}

assembly::Model recut(const Specification& scene, const assembly::Model& model, std::vector<geometry::Crack> cracks) {
  return discretise(relative_to(model.origin, scene), model.mesh, std::move(cracks),
                    {model.surfaces.springs, model.surfaces.mortar});
}

solve::StepControls step_controls(const Specification& scene) {
  solve::StepControls c;
  c.steps = scene.loading.steps;
  c.outputs = scene.loading.outputs;
  c.accuracy = scene.solver.accuracy;
  c.kinks = kinks_of(scene);
  c.min_step = scene.solver.min_step;
  if (scene.solver.max_plastic_increment > 0.0) c.max_flow = scene.solver.max_plastic_increment;
  c.control = scene.loading.control;
  c.newton = {scene.solver.residual_tolerance, scene.solver.correction_tolerance, scene.solver.min_iterations,
              scene.solver.max_iterations, scene.solver.extrapolate};
  return c;
}

}  // namespace cleft::problem
