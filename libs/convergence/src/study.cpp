#include "cleft/convergence/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <mutex>
#include <numeric>
#include <set>
#include <span>

#include "cleft/problem/build.hpp"
#include "cleft/scene/json.hpp"
#include "cleft/scene/read.hpp"
#include "cleft/support/files.hpp"
#include "cleft/support/process.hpp"
#include "parallel.hpp"
#include "study_files.hpp"
#include "study_values.hpp"

namespace cleft::convergence {
namespace {

using scene::Quantity;

constexpr double kUndetermined = std::numeric_limits<double>::quiet_NaN();

// One run that is asked for: the scene and how the program is told of it.
struct Task {
  problem::Specification scene;
  std::vector<std::string> overrides;
};

// A swept text reads better without its quotes.
std::string label(const std::string& toml) {
  if (toml.size() > 1 && (toml.front() == '\'' || toml.front() == '"')) return toml.substr(1, toml.size() - 2);
  return toml;
}

std::string file_name(std::string text) {
  for (char& c : text)
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '.' && c != '-') c = '_';
  return text;
}

// Loads at which the study looks must be hit and written.
std::string outputs_override(const scene::Study& study, const problem::Specification& s) {
  std::set<double> loads;
  if (!s.loading.every_step) loads.insert(s.loading.outputs.begin(), s.loading.outputs.end());
  for (const auto& q : study.quantities) loads.insert(q.load);
  return fmt::format("loading.outputs=[{}]", fmt::join(loads, ", "));
}

Task task_of(const scene::Study& study, const std::string& mesh, const std::string& variant) {
  Task task;
  task.overrides = study.set;
  task.overrides.push_back(study.mesh_key + "=" + mesh);
  if (!study.sweep_key.empty()) task.overrides.push_back(study.sweep_key + "=" + variant);
  task.overrides.push_back(outputs_override(study, scene::read_scene(study.scene, task.overrides)));
  task.scene = scene::read_scene(study.scene, task.overrides);
  return task;
}

// What is wrong with the scene of a run stands where the study asks for it.
[[noreturn]] void tell_in_study(const scene::Study& study, const InputError& error) {
  const std::string override = "--set ", &place = error.location().file;
  const auto at = study.overrides_at.find(place.starts_with(override) ? place.substr(override.size()) : "");
  if (at != study.overrides_at.end()) throw InputError(at->second, error.key(), error.problem());
  throw InputError(study.scene_at, "scene", error.what());
}

bool is_done(const std::string& folder) {
  const std::string path = folder + "/run.json";
  return std::filesystem::exists(path) && read_bytes(path).find("\"end\": \"done\"") != std::string::npos;
}

// Runs what is missing. Returns what failed.
std::vector<std::string> run_all(const scene::Study& study, const StudyOptions& options, const std::vector<Task>& tasks,
                                 std::vector<StudyRun>& runs) {
  std::vector<std::size_t> order(tasks.size());  // finest first: the longest run must not start last
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return runs[a].h < runs[b].h; });
  std::vector<std::string> failed;
  std::mutex one;
  for_each_parallel(tasks.size(), options.jobs, [&](std::size_t k) {
    const std::size_t i = order[k];
    StudyRun& run = runs[i];
    run.reused = is_done(run.folder);
    int code = 0;
    if (!run.reused) {
      std::vector<std::string> command{options.program, "run", study.scene, "--output", run.folder};
      for (const auto& o : tasks[i].overrides) command.insert(command.end(), {"--set", o});
      if (std::filesystem::exists(run.folder + "/checkpoint")) command.emplace_back("--resume");
      code = call(command, run.folder + ".log");
    }
    const std::lock_guard lock(one);
    const std::string name = fmt::format("{}{}{}", run.mesh, run.variant.empty() ? "" : " ", run.variant);
    if (code != 0) failed.push_back(fmt::format("{}: exit code {}, see {}.log", name, code, run.folder));
    if (options.tell)
      options.tell(fmt::format("{} {}", name, run.reused ? "was there" : code == 0 ? "done" : "FAILED"));
  });
  return failed;
}

// Whether a run is the one that the profiles of the others are compared with: the finest of its variant.
bool is_reference(const Quantity& q, const std::vector<StudyRun>& runs, std::size_t i) {
  const bool last = i + 1 == runs.size() || runs[i + 1].variant != runs[i].variant;
  return last && q.kind == Quantity::Kind::Profile && q.reference.empty();
}

// Differences from the last value over its size, or absolute where that is 0.
std::vector<double> from_last(const std::vector<double>& value) {
  const double scale = value.back() != 0.0 ? std::fabs(value.back()) : 1.0;
  std::vector<double> out;
  for (const double v : value) out.push_back(std::fabs(v - value.back()) / scale);
  return out;
}

Series series_of(const scene::Study& study, std::size_t quantity, const std::vector<StudyRun>& runs,
                 const std::string& variant) {
  const Quantity& q = study.quantities[quantity];
  Series out;
  out.quantity = quantity;
  out.variant = variant;
  std::vector<double> h, value;
  FitOptions options;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (runs[i].variant != variant) continue;
    if (is_reference(q, runs, i)) options.reference_h = runs[i].h;
    if (!std::isfinite(runs[i].value[quantity])) continue;
    out.runs.push_back(i);
    h.push_back(runs[i].h);
    value.push_back(runs[i].value[quantity]);
  }
  const bool is_value = q.kind == Quantity::Kind::History;
  out.from_finest.assign(h.size(), kUndetermined);
  if (is_value && !value.empty()) out.from_finest = from_last(value);
  options.limit = is_value ? q.exact : std::optional(0.0);
  if (h.size() < 2) {
    out.fit.remark = "too few meshes";
    out.fit.limit = out.fit.order = kUndetermined;
  } else {
    out.fit = fit_limit(h, value, options);
  }
  out.has_errors = options.limit || out.fit.determined;
  for (const double v : value) out.error.push_back(out.has_errors ? std::fabs(v - out.fit.limit) : kUndetermined);
  if (is_value && out.has_errors && std::isfinite(out.fit.limit) && out.fit.limit != 0.0)
    out.scale = std::fabs(out.fit.limit);
  return out;
}

std::vector<Cost> costs_of(std::span<const StudyRun> runs) {
  std::vector<Cost> out;
  std::vector<double> unknowns;
  for (const auto& run : runs) unknowns.push_back(static_cast<double>(run.unknowns));
  const auto add = [&](const std::string& what, const auto& of) {
    std::vector<double> cost;
    for (const auto& run : runs) cost.push_back(of(run));
    out.push_back({runs[0].variant, what, fit_power(unknowns, cost)});
  };
  add("seconds", [](const StudyRun& run) { return run.seconds; });
  add("megabytes", [](const StudyRun& run) { return run.megabytes; });
  add("iterations", [](const StudyRun& run) { return static_cast<double>(run.iterations); });
  for (const auto& [phase, seconds] : runs[0].phases)
    add(phase + "_seconds", [&name = phase](const StudyRun& run) { return run.phases.at(name); });
  return out;
}

void check_series(const Quantity& q, const Series& s, std::vector<std::string>& missed) {
  const std::string name = q.name + (s.variant.empty() ? "" : ", " + s.variant);
  const auto check = [&](const char* what, double value, const auto& within) {
    if (within && !(value >= (*within)[0] && value <= (*within)[1]))
      missed.push_back(
          fmt::format("{}: {} {:.4g} is not within [{}, {}]", name, what, value, (*within)[0], (*within)[1]));
  };
  if (s.has_errors) {
    check("order", s.fit.order, q.order_within);
    check("limit", s.fit.limit, q.limit_within);
  } else if (q.order_within || q.limit_within)
    missed.push_back(fmt::format("{}: no limit is determined: {}", name, s.fit.remark));
}

}  // namespace

StudyResult run_study(const scene::Study& study, const StudyOptions& options) {
  StudyResult result;
  std::vector<Task> tasks;
  const std::string program = read_bytes(options.program);
  const std::size_t identity = std::hash<std::string>{}(program)&0xffffffffU;
  for (const auto& variant : study.variants)
    for (const auto& mesh : study.meshes) {
      assembly::Model model;  // what only shows on the mesh is said before anything runs
      try {
        tasks.push_back(task_of(study, mesh, variant));
        model = problem::build_model(tasks.back().scene);
      } catch (const InputError& error) {
        tell_in_study(study, error);
      }
      const auto& s = tasks.back().scene;
      StudyRun run;
      const auto* structured = std::get_if<problem::StructuredMesh>(&s.mesh.kind);
      run.mesh = structured ? fmt::format("{}x{}", structured->cells[0], structured->cells[1]) : "refine " + mesh;
      run.variant = label(variant);
      run.h = geometry::mean_element_size(model.mesh);
      run.unknowns = model.unknowns.components();
      // named by all that the result depends on: the scene and the program itself
      run.folder = fmt::format("{}/runs/{}_{}{:08x}", options.directory,
                               file_name(run.mesh + (run.variant.empty() ? "" : "_" + run.variant)),
                               scene::scene_hash(s), identity);
      if (!result.runs.empty() && result.runs.back().variant == run.variant && !(run.h < result.runs.back().h))
        throw InputError({study.file}, study.mesh_key, "the meshes must get finer; allowed: coarsest first");
      result.runs.push_back(run);
      check_quantities(study, s);
    }
  std::filesystem::create_directories(options.directory + "/runs");
  result.failed = run_all(study, options, tasks, result.runs);
  if (!result.failed.empty()) return result;

  const std::size_t meshes = study.meshes.size();
  for (auto& run : result.runs) read_counts(run);
  for (std::size_t first = 0; first < result.runs.size(); first += meshes) {
    const auto of_variant = std::span(result.runs).subspan(first, meshes);
    read_values(study, of_variant);
    const auto costs = costs_of(of_variant);
    result.costs.insert(result.costs.end(), costs.begin(), costs.end());
  }
  for (std::size_t k = 0; k < study.quantities.size(); ++k)
    for (std::size_t v = 0; v < study.variants.size(); ++v) {
      result.series.push_back(series_of(study, k, result.runs, result.runs[v * meshes].variant));
      check_series(study.quantities[k], result.series.back(), result.missed);
    }
  write_study(study, result, options.directory);
  return result;
}

}  // namespace cleft::convergence
