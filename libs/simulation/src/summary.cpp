#include "summary.hpp"

#include <array>
#include <nlohmann/json.hpp>

#include "cleft/problem/build.hpp"
#include "cleft/scene/json.hpp"

namespace cleft::simulation {
namespace {

using Json = nlohmann::ordered_json;

const char* name_of(RunResult::End end) {
  switch (end) {
    case RunResult::End::Done:
      return "done";
    case RunResult::End::Failed:
      return "failed";
    case RunResult::End::Stopped:
      return "stopped";
    case RunResult::End::NotWritten:
      return "not written";
  }
  return "";
}

Json mesh_of(const assembly::Model& model) {
  return {{"nodes", model.mesh.nodes.size()},
          {"elements", model.mesh.triangles.size()},
          {"cut_elements", model.cut.elements.size()}};
}

Json unknowns_of(const solve::LoadStepper& stepper) {
  const auto& unknowns = stepper.model().unknowns;
  return {{"standard", 2 * unknowns.nodes},
          {"enriched", 2 * (unknowns.first_amplitude - unknowns.nodes)},
          {"tips", 2 * (unknowns.displacements() - unknowns.first_amplitude)},
          {"multipliers", 2 * unknowns.multipliers},
          {"prescribed", stepper.constraints().size()},
          {"contact_points", stepper.model().surfaces.points.size()}};
}

const char* factorisation_of(const assembly::Model& model) {
  return solve::LoadStepper::factorisation_for(model) == solve::Factorisation::Symmetric ? "symmetric" : "unsymmetric";
}

Json history_of(const assembly::History& history) {
  return {{"contact", history.contact.size()},
          {"plastic", history.plastic.size()},
          {"bytes", history.contact.size() * sizeof(contact::ContactState) +
                        history.plastic.size() * sizeof(constitutive::PlasticState)}};
}

// What it took: seconds, factorisations, memory.
void add_costs(Json& j, const growth::Evolution& evolution, const RunResult& result, double total_seconds) {
  const auto& stepper = evolution.stepper();
  const auto solver = evolution.solver_seconds();
  j["seconds"]["total"] = total_seconds;
  for (const auto& [phase, spent] : result.phases) j["seconds"][phase] = spent;
  j["assemblies"] = evolution.assembly_seconds().assemblies;
  j["factorisations"] = solver.factorisations;
  j["factorisations_repeated"] = solver.second_opinions;
  j["analyses"] = solver.analyses;
  j["linear"] = evolution.model().is_linear();
  j["history"] = history_of(stepper.state().history);
  j["current_faces"] = stepper.face_positions().start.size();
  j["yardstick_seconds"] = result.solver_seconds;
  j["microseconds"] = {{"cell", result.bulk_microseconds}, {"contact_point", result.contact_microseconds}};
  j["peak_megabytes"] = result.peak_megabytes;
}

// By crack; null where all contact is mortar contact.
Json penalties_of(const assembly::Model& model) {
  Json j;
  for (std::size_t k = 0; k < model.surfaces.springs.size(); ++k) {
    const auto& springs = model.surfaces.springs[k];
    if (model.surfaces.is_mortar(static_cast<Index>(k))) continue;
    j[model.cracks[k].name] = {{"normal", springs.normal}, {"tangential", springs.tangential}};
  }
  return j;
}

Json error_of(const problem::FieldSpec& exact, const solve::LoadStepper& stepper) {
  const auto& model = stepper.model();
  const auto e = problem::error_norms(model, problem::make_field(exact, model.constants(0), model.origin),
                                      stepper.state().load, stepper.state().displacement);
  return {{"l2", e.l2},
          {"l2_relative", e.l2 / e.l2_exact},
          {"energy", e.energy},
          {"energy_relative", e.energy / e.energy_exact}};
}

// Where the cracks are that have grown, as growth.csv tells it advance by advance.
Json growth_of(const growth::Evolution& evolution) {
  Json j;
  for (std::size_t c = 0; c < evolution.record().points.size(); ++c) {
    const auto& tips = evolution.record().tips[c];
    auto& crack = j[evolution.model().cracks[c].name];
    crack["advances"] = std::array{tips[0].advances, tips[1].advances};
    for (const Vec2& local : evolution.record().points[c]) {
      const Vec2 p = evolution.model().in_scene(local);
      crack["points"].push_back(std::array{p.x(), p.y()});
    }
  }
  return j;
}

// What came out of it.
void add_outcome(Json& j, const problem::Specification& specification, const growth::Evolution& evolution,
                 const RunResult& result) {
  j["increments"] = result.increments;
  j["iterations"] = result.iterations;
  j["cuts"] = result.cuts;
  if (auto penalties = penalties_of(evolution.model()); !penalties.is_null()) j["penalties"] = std::move(penalties);
  j["overlap"] = result.overlap;
  j["worst_residual"] = result.worst_residual;
  j["newton_order"] = result.newton_order > 0.0 ? Json(result.newton_order) : Json();
  if (specification.exact && result.end == RunResult::End::Done)
    j["error"] = error_of(*specification.exact, evolution.stepper());
  for (const auto& point : result.critical)
    j["critical_points"].push_back(
        {{"kind", name_of(point.kind)}, {"before", point.before}, {"load", point.load}, {"step", point.step}});
  if (grows(specification)) j["growth"] = growth_of(evolution);
}

}  // namespace

std::string summary(const problem::Specification& specification, const growth::Evolution& evolution,
                    const RunResult& result, double total_seconds, const std::vector<std::string>& notes) {
  Json j;
  j["cleft"] = CLEFT_VERSION;
  j["end"] = name_of(result.end);
  if (result.end == RunResult::End::Failed) j["failure"] = result.reason;
  j["load"] = result.load;
  j["last_load"] = result.last_load;
  j["mesh"] = mesh_of(evolution.model());
  j["unknowns"] = unknowns_of(evolution.stepper());
  j["factorisation"] = factorisation_of(evolution.model());
  add_costs(j, evolution, result, total_seconds);
  add_outcome(j, specification, evolution, result);
  j["remarks"] = notes;
  for (const auto& remark : result.remarks) j["remarks"].push_back(remark);
  j["scene"] = Json::parse(scene::to_json(specification));
  return j.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace cleft::simulation
