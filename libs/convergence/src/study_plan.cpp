#include "study_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "cleft/problem/build.hpp"
#include "cleft/scene/json.hpp"
#include "cleft/scene/read.hpp"
#include "cleft/support/files.hpp"
#include "study_values.hpp"

namespace cleft::convergence {
namespace {

std::string file_name(std::string text) {
  for (char& c : text)
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '.' && c != '-') c = '_';
  constexpr std::size_t kLongest = 100;  // the hash behind it tells runs apart
  return text.substr(0, kLongest);
}

// A path may come back to a load, and the last state there counts.
double last_load(const scene::Study& study, const problem::Specification& s) {
  if (s.loading.control == solve::Control::Path) return 1.0;
  return std::ranges::max(study.quantities, {}, &scene::Quantity::load).load;
}

// Loads at which the study looks must be hit and written.
std::string outputs_override(const scene::Study& study, const problem::Specification& s) {
  std::set<double> loads;
  if (!s.loading.every_step) loads.insert(s.loading.outputs.begin(), s.loading.outputs.end());
  for (const auto& q : study.quantities) loads.insert(q.load);
  loads.erase(loads.upper_bound(last_load(study, s)), loads.end());
  return fmt::format("loading.outputs=[{}]", fmt::join(loads, ", "));
}

Task task_of(const scene::Study& study, const scene::Setting& place, const scene::Setting& variant) {
  Task task;
  task.overrides = study.set;
  for (const auto* setting : {&place, &variant})
    task.overrides.insert(task.overrides.end(), setting->set.begin(), setting->set.end());
  task.overrides.push_back(outputs_override(study, scene::read_scene(study.scene, task.overrides)));
  task.scene = scene::read_scene(study.scene, task.overrides);
  task.last_load = last_load(study, task.scene);
  return task;
}

// What is wrong with the scene of a run stands where the study asks for it.
[[noreturn]] void tell_in_study(const scene::Study& study, const InputError& error) {
  const std::string override = "--set ", &place = error.location().file;
  const auto at = study.overrides_at.find(place.starts_with(override) ? place.substr(override.size()) : "");
  if (at != study.overrides_at.end()) throw InputError(at->second, error.key(), error.problem());
  throw InputError(study.scene_at, "scene", error.what());
}

// What a task and its mesh make of a run, which is named by all that the result depends on: the scene and the program
// itself.
StudyRun run_of(const Task& task, const scene::Setting& place, const scene::Setting& variant) {
  const assembly::Model model = problem::build_model(task.scene);  // what only shows on the mesh is said here, too
  StudyRun run;
  run.mesh = place.label;
  run.variant = variant.label;
  run.h = place.h > 0.0 ? place.h : geometry::mean_element_size(model.mesh);
  run.unknowns = model.unknowns.components();
  run.folder = file_name(title_of(run)) + "_" + scene::scene_hash(task.scene);
  return run;
}

void check_gets_finer(const scene::Study& study, const std::vector<StudyRun>& runs) {
  if (runs.size() < 2) return;
  const StudyRun &run = runs.back(), &before = runs[runs.size() - 2];
  if (run.variant == before.variant && !(run.h < before.h))
    throw InputError(study.sequence_at, study.sequence_keys.front(),
                     fmt::format("{} is not finer than {}: the elements are {:.4g} m and {:.4g} m; allowed: coarsest "
                                 "first, the meshes must get finer",
                                 run.mesh, before.mesh, run.h, before.h));
}

}  // namespace

std::string title_of(const StudyRun& run) {
  if (run.mesh.empty() && run.variant.empty()) return "run";
  return run.mesh + (run.mesh.empty() || run.variant.empty() ? "" : ", ") + run.variant;
}

Plan plan_of(const scene::Study& study, const StudyOptions& options) {
  Plan plan;
  const std::size_t identity = std::hash<std::string>{}(read_bytes(options.program)) & 0xffffffffU;
  for (const auto& variant : study.variants)
    for (const auto& place : study.sequence) {
      try {
        plan.tasks.push_back(task_of(study, place, variant));
        plan.runs.push_back(run_of(plan.tasks.back(), place, variant));
      } catch (const InputError& error) {
        tell_in_study(study, error);
      }
      auto& folder = plan.runs.back().folder;
      folder = fmt::format("{}/runs/{}{:08x}", options.directory, folder, identity);
      check_gets_finer(study, plan.runs);
      check_quantities(study, plan.tasks.back().scene);
    }
  return plan;
}

}  // namespace cleft::convergence
