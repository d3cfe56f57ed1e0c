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

geometry::CutMesh cut_located(const Specification& specification, const geometry::Mesh& mesh,
                              const std::vector<geometry::Crack>& cracks) {
  try {
    return geometry::cut(mesh, cracks);
  } catch (const geometry::CrackError& error) {
    const auto crack = std::ranges::find(specification.cracks, error.crack(), &CrackSpec::name);
    if (crack == specification.cracks.end()) throw;
    throw InputError(crack->at, crack->at.part("crack", crack->name), error.problem());
  }
}

// What a crack divides and enriches, before anything acts on it.
void enrich(const Specification& specification, assembly::Model& m) {
  m.cut = cut_located(specification, m.mesh, m.cracks);
  m.unknowns = enrichment::number_unknowns(m.mesh, m.cut);
  if (specification.kinematics == Kinematics::Finite) m.unknowns.blunting = enrichment::kBlunting;
  m.cells = enrichment::make_cells(m.mesh, m.cut, m.unknowns);
  if (!m.cut.tips.empty()) m.tip_points = enrichment::make_tip_points(m.mesh, m.cut, m.unknowns);
  m.ties = enrichment::make_ghost_ties(m.mesh, m.cut, m.unknowns, m.cells);
}

assembly::Model discretise(const LocalSpecification& local, geometry::Mesh mesh, std::vector<geometry::Crack> cracks,
                           const ContactScales& earlier) {
  const Specification& specification = local.specification;
  assembly::Model m;
  m.origin = local.origin;
  m.mesh = std::move(mesh);
  m.cracks = std::move(cracks);
  enrich(specification, m);
  fill_with_materials(specification, m);
  if (specification.f_bar) m.f_bar_partner = assembly::pair_cells(m);
  if (!specification.cracks.empty()) set_up_contact(specification, earlier, m);
  prescribe(specification, m);
  add_dead_loads(specification, m);
  return m;
}

}  // namespace

assembly::Model build_model(const Specification& specification) {
  auto [local, mesh] = make_mesh(specification);
  auto cracks = make_cracks(local.specification, mesh);
  auto m = discretise(local, std::move(mesh), std::move(cracks), {});
  refuse_idle_growth(specification, m);
  refuse_narrow_tips(specification, m);
  return m;
}

assembly::Model recut(const Specification& specification, const assembly::Model& model,
                      std::vector<geometry::Crack> cracks) {
  return discretise(relative_to(model.origin, specification), model.mesh, std::move(cracks),
                    {model.surfaces.springs, model.surfaces.mortar});
}

solve::StepControls step_controls(const Specification& specification) {
  solve::StepControls c;
  c.steps = specification.loading.steps;
  c.outputs = specification.loading.outputs;
  c.accuracy = specification.solver.accuracy;
  c.kinks = kinks_of(specification);
  c.min_step = specification.solver.min_step;
  if (specification.solver.max_plastic_increment > 0.0) c.max_flow = specification.solver.max_plastic_increment;
  c.control = specification.loading.control;
  c.newton = {specification.solver.residual_tolerance, specification.solver.correction_tolerance,
              specification.solver.min_iterations, specification.solver.max_iterations,
              specification.solver.extrapolate};
  return c;
}

}  // namespace cleft::problem
