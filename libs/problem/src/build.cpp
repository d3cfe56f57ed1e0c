#include "cleft/problem/build.hpp"

#include <algorithm>

#include "boundaries.hpp"
#include "cleft/assembly/f_bar.hpp"
#include "cleft/problem/tip_reach.hpp"
#include "contact.hpp"
#include "dead_loads.hpp"
#include "growth_check.hpp"
#include "loads.hpp"
#include "materials.hpp"
#include "meshing.hpp"

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

// What a crack divides and enriches, before anything acts on it.
void enrich(const Specification& scene, assembly::Model& m) {
  m.cut = cut_located(scene, m.mesh, m.cracks);
  m.unknowns = enrichment::number_unknowns(m.mesh, m.cut);
  if (scene.kinematics == Kinematics::Finite) m.unknowns.blunting = enrichment::kBlunting;
  m.cells = enrichment::make_cells(m.mesh, m.cut, m.unknowns);
  if (!m.cut.tips.empty()) m.tip_points = enrichment::make_tip_points(m.mesh, m.cut, m.unknowns);
  m.ties = enrichment::make_ghost_ties(m.mesh, m.cut, m.unknowns, m.cells);
}

assembly::Model discretise(const LocalSpecification& local, geometry::Mesh mesh, std::vector<geometry::Crack> cracks,
                           const ContactScales& earlier) {
  const Specification& scene = local.scene;
  assembly::Model m;
  m.origin = local.origin;
  m.mesh = std::move(mesh);
  m.cracks = std::move(cracks);
  enrich(scene, m);
  fill_with_materials(scene, m);
  if (scene.f_bar) m.f_bar_partner = assembly::pair_cells(m);
  if (!scene.cracks.empty()) set_up_contact(scene, earlier, m);
  prescribe(scene, m);
  add_dead_loads(scene, m);
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
