#include "cleft/objectivity/swap.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "cleft/convergence/run_cache.hpp"
#include "cleft/geometry/mesh.hpp"
#include "cleft/objectivity/turned.hpp"
#include "cleft/problem/build.hpp"
#include "cleft/scene/json.hpp"
#include "cleft/scene/read.hpp"
#include "cleft/simulation/run.hpp"
#include "judge.hpp"

namespace cleft::objectivity {
namespace {

using contact::NegativeSide;

constexpr std::array kSides{NegativeSide::Left, NegativeSide::Right, NegativeSide::Both};

// One mesh that is asked for.
struct Task {
  problem::Specification scene;
  std::string label;
  double h = 0.0;
};

// A mesh's override says more than enough: 16x32 of mesh.cells=[16,32].
std::string label_of(const problem::Specification& scene, const std::string& override) {
  if (const auto* structured = std::get_if<problem::StructuredMesh>(&scene.mesh.kind))
    return fmt::format("{}x{}", structured->cells[0], structured->cells[1]);
  if (const auto* delaunay = std::get_if<problem::DelaunayMesh>(&scene.mesh.kind))
    return fmt::format("refine {:g}", delaunay->refine);
  return override.empty() ? "mesh" : std::filesystem::path(std::get<problem::GmshMesh>(scene.mesh.kind).file).stem();
}

std::vector<std::string> names_of_cracks(const problem::Specification& scene) {
  std::vector<std::string> out;
  for (const auto& crack : scene.cracks) out.push_back(crack.name);
  return out;
}

// The cracks that change their side.
std::vector<std::string> cracks_to_swap(const problem::Specification& scene, const std::optional<std::string>& wanted) {
  auto all = names_of_cracks(scene);
  if (all.empty())
    throw InputError({scene.file}, "crack", "missing; allowed: a scene with a crack, whose sides can be swapped");
  if (!wanted) return all;
  if (std::ranges::find(all, *wanted) == all.end())
    throw InputError({"command line"}, "--crack",
                     fmt::format("the scene has no crack '{}'; allowed: {}", *wanted, fmt::join(all, ", ")));
  return {*wanted};
}

Task task_of(const std::string& file, const SwapOptions& options, const std::string& mesh) {
  auto overrides = options.overrides;
  if (!mesh.empty()) overrides.push_back(mesh);
  Task out;
  out.scene = scene::read_scene(file, overrides);
  out.scene.loading.outputs = {options.load};
  out.scene.loading.every_step = false;
  out.label = label_of(out.scene, mesh);
  out.h = geometry::mean_element_size(problem::build_model(out.scene).mesh);
  return out;
}

std::vector<Task> tasks_of(const std::string& file, const SwapOptions& options) {
  std::vector<Task> out;
  for (const auto& mesh : options.meshes.empty() ? std::vector<std::string>{""} : options.meshes) {
    out.push_back(task_of(file, options, mesh));
    if (out.size() > 1 && !(out.back().h < out[out.size() - 2].h))
      throw InputError({"command line"}, "--meshes", "the meshes must get finer; allowed: coarsest first");
  }
  return out;
}

problem::Specification with_side(problem::Specification scene, const std::vector<std::string>& cracks,
                                 NegativeSide side) {
  for (auto& crack : scene.cracks)
    if (std::ranges::find(cracks, crack.name) != cracks.end()) crack.negative_side = side;
  return scene;
}

class Runs {
 public:
  Runs(const SwapOptions& options, SwapResult& result) : options_(options), result_(result) {}

  // Nothing if the run does not get to the load.
  std::optional<Solution> solve(const problem::Specification& scene, const std::string& name) {
    const std::string folder = folder_of(scene, name);
    std::string early;
    try {
      const bool was_there = convergence::is_sealed(folder);
      if (!was_there) early = run(scene, folder);
      const auto out = read_solution(folder, options_.load, scene);
      if (!was_there) convergence::seal(folder);
      tell(was_there ? name + ": was there"
                     : fmt::format("{}: {} increments, {} iterations", name, out.increments, out.iterations));
      return out;
    } catch (const InputError&) {
      throw;
    } catch (const std::runtime_error& error) {
      result_.failed.push_back(fmt::format("{}: {}{}", name, early, error.what()));
      tell(result_.failed.back());
      return std::nullopt;
    }
  }

 private:
  // Named by all that the result depends on: the scene and the program itself.
  std::string folder_of(const problem::Specification& scene, std::string name) const {
    std::ranges::replace_if(
        name, [](unsigned char c) { return !std::isalnum(c) && c != '.' && c != '-'; }, '_');
    return fmt::format("{}/runs/{}_{}", options_.directory, name,
                       scene::hash_of(scene::scene_hash(scene) + options_.identity));
  }

  // Until the load, or a whole path, which may come back to the load. Says how it ended before its end. Throws
  // std::runtime_error where its files cannot be written.
  std::string run(const problem::Specification& scene, const std::string& folder) const {
    simulation::RunOptions run;
    run.directory = folder;
    run.threads = options_.threads;
    run.last_load = scene.loading.control == solve::Control::Path ? 1.0 : options_.load;
    const auto result = simulation::run(scene, run);
    using End = simulation::RunResult::End;
    if (result.end == End::NotWritten) throw std::runtime_error(result.unwritten);
    return result.end == End::Done ? "" : fmt::format("ended at load {:.6g}: {}; ", result.load, result.reason);
  }

  void tell(const std::string& line) const {
    if (options_.tell) options_.tell(line);
  }

  const SwapOptions& options_;
  SwapResult& result_;
};

// All sides of a scene, without those that fail.
std::vector<Solution> solve_sides(const problem::Specification& scene, const std::string& name,
                                  const std::vector<std::string>& cracks, Runs& runs) {
  std::vector<Solution> out;
  for (const auto side : kSides) {
    const std::string label(cleft::name_of(side));
    auto solution = runs.solve(with_side(scene, cracks, side), name + " " + label);
    if (!solution) continue;
    solution->side = label;
    out.push_back(std::move(*solution));
  }
  return out;
}

}  // namespace

SwapResult swap_sides(const std::string& file, const SwapOptions& options) {
  const auto tasks = tasks_of(file, options);
  SwapResult result;
  result.cracks = cracks_to_swap(tasks[0].scene, options.crack);
  std::optional<problem::Specification> turned_scene;
  if (options.degrees) turned_scene = turned(tasks[0].scene, *options.degrees, options.directory + "/turned.msh");
  std::filesystem::create_directories(options.directory + "/runs");
  Runs runs(options, result);
  for (const auto& task : tasks) {
    SwapMesh mesh{task.label, task.h, solve_sides(task.scene, task.label, result.cracks, runs), {}};
    if (mesh.solutions.size() == kSides.size()) mesh.differences = differences(mesh.solutions, options.part);
    result.meshes.push_back(std::move(mesh));
  }
  result.sides = judge_sides(result.meshes, options);
  if (turned_scene) {
    for (auto& solution : solve_sides(*turned_scene, tasks[0].label + " turned", result.cracks, runs))
      result.turned.push_back(turned_back(std::move(solution), *options.degrees));
    result.turn = judge_turn(result.meshes[0], result.turned, options.part);
  }
  result.verdict = verdict_of(result);
  return result;
}

}  // namespace cleft::objectivity
