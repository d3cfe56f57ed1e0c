#include "cleft/simulation/run.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>

#include "cleft/problem/build.hpp"
#include "cleft/problem/tip_reach.hpp"
#include "cleft/results/critical_points.hpp"
#include "cleft/results/results.hpp"
#include "cleft/scene/json.hpp"
#include "cleft/scene/solved_keys.hpp"
#include "cleft/simulation/failure_words.hpp"
#include "cleft/simulation/remarks.hpp"
#include "cleft/support/timer.hpp"
#include "remarks_at_end.hpp"
#include "run_folder.hpp"

namespace cleft::simulation {
namespace {

// The BLAS behind the factorisation is found at run time: whichever the system has.
void set_blas_threads(int threads) {
  if (auto* set = reinterpret_cast<void (*)(int)>(dlsym(RTLD_DEFAULT, "openblas_set_num_threads"))) set(threads);
}

// Not getrusage: its peak begins with that of the process which called this one.
double peak_megabytes() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmHWM:")) return std::stod(line.substr(6)) / 1024.0;
  return 0.0;
}

double median(std::vector<double> v) {
  if (v.empty()) return 0.0;
  std::nth_element(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(v.size() / 2), v.end());
  return v[v.size() / 2];
}

results::Checkpoint read_checkpoint(const problem::Specification& scene, const std::string& path) {
  results::Checkpoint c = results::checkpoint_from(results::read_bytes(path), path);
  const std::string now = scene::solved_json(scene);
  if (c.scene == now) return c;
  constexpr std::size_t kTold = 8;
  auto changed = scene::differences(c.scene, now);
  if (changed.size() > kTold) {
    changed[kTold] = fmt::format("{} more", changed.size() - kTold);
    changed.resize(kTold + 1);
  }
  throw std::runtime_error(
      fmt::format("{}: the checkpoint belongs to another scene, which differs in {}; run with the keys as before, "
                  "without --resume, or into another folder",
                  path, fmt::join(changed, ", ")));
}

// Removes what an earlier run left in the folder and this one might not replace: exactly the files that its checkpoint
// lists. Whatever else lies there is not ours. Returns what there is to tell of it, if anything.
std::string remove_results(const std::string& directory) {
  const std::string checkpoint = directory + "/checkpoint";
  const std::string others = std::filesystem::is_empty(directory) ? "" : directory + ": other files lie there and stay";
  if (!std::filesystem::exists(checkpoint)) return others;
  results::Checkpoint earlier;
  try {
    earlier = results::checkpoint_from(results::read_bytes(checkpoint), checkpoint);
  } catch (const std::runtime_error&) {
    return others;  // not a checkpoint of ours: nothing is known of the files beside it
  }
  const auto remove = [&](const std::string& name) { std::filesystem::remove(directory + "/" + name); };
  for (const auto& [name, bytes] : earlier.log_bytes) remove(name);
  for (const auto& output : earlier.outputs) remove(output.file);
  remove("run.json");
  remove("checkpoint");
  return directory + ": replaces the results of an earlier run" +
         (std::filesystem::exists(directory + "/report") ? "; its report stays until `cleft report` draws the new one"
                                                         : "");
}

struct Seconds {
  double before = 0.0;  // of the parts that this run goes on from
  double cut = 0.0, write = 0.0;
};

void count(const growth::Step& step, results::Rounded& rounded) {
  if (!(step.rounded > solve::kUnnoticedResidual)) return;
  ++rounded.increments;
  if (step.rounded <= rounded.worst) return;
  rounded.worst = step.rounded;
  rounded.load = step.load;
}

// Where the cracks are that have grown, as CSV's growth.csv tells it advance by advance.
nlohmann::ordered_json grown(const growth::Evolution& evolution) {
  nlohmann::ordered_json j;
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

nlohmann::ordered_json summary(const problem::Specification& scene, const growth::Evolution& evolution,
                               const RunResult& result, const Seconds& seconds, const std::vector<std::string>& notes) {
  const auto& stepper = evolution.stepper();
  const auto& model = evolution.model();
  const auto solver = evolution.solver_seconds();
  const char* const ends[] = {"done", "failed", "stopped", "not written"};
  nlohmann::ordered_json j;
  j["cleft"] = CLEFT_VERSION;
  j["end"] = ends[static_cast<int>(result.end)];
  if (result.end == RunResult::End::Failed) j["failure"] = result.reason;
  j["load"] = result.load;
  j["mesh"] = {{"nodes", model.mesh.nodes.size()},
               {"elements", model.mesh.triangles.size()},
               {"cut_elements", model.cut.elements.size()}};
  j["unknowns"] = {{"standard", 2 * model.unknowns.nodes},
                   {"enriched", 2 * (model.unknowns.first_amplitude - model.unknowns.nodes)},
                   {"tips", 2 * (model.unknowns.displacements() - model.unknowns.first_amplitude)},
                   {"multipliers", 2 * model.unknowns.multipliers},
                   {"prescribed", stepper.constraints().size()},
                   {"contact_points", model.surfaces.points.size()}};
  j["factorisation"] =
      solve::LoadStepper::factorisation_for(model) == solve::Factorisation::Symmetric ? "symmetric" : "unsymmetric";
  j["seconds"]["total"] = seconds.before + result.seconds;
  for (const auto& [phase, spent] : result.phases) j["seconds"][phase] = spent;
  j["assemblies"] = evolution.assembly_seconds().assemblies;
  j["factorisations"] = solver.factorisations;
  j["factorisations_repeated"] = solver.second_opinions;
  j["analyses"] = solver.analyses;
  j["linear"] = model.is_linear();
  const auto& history = stepper.state().history;
  j["history"] = {{"contact", history.contact.size()},
                  {"plastic", history.plastic.size()},
                  {"bytes", history.contact.size() * sizeof(contact::Memory) +
                                history.plastic.size() * sizeof(constitutive::PlasticState)}};
  j["current_faces"] = stepper.face_positions().start.size();
  j["yardstick_seconds"] = result.yardstick;
  j["microseconds"] = {{"cell", result.bulk_microseconds}, {"contact_point", result.contact_microseconds}};
  j["peak_megabytes"] = result.peak_megabytes;
  j["increments"] = result.increments;
  j["iterations"] = result.iterations;
  j["cuts"] = result.cuts;
  for (std::size_t k = 0; k < model.surfaces.laws.size(); ++k) {
    const auto& law = model.surfaces.laws[k];
    if (model.surfaces.is_mortar(static_cast<Index>(k))) continue;
    j["penalties"][model.cracks[k].name] = {{"normal", law.normal_penalty}, {"tangential", law.tangential_penalty}};
  }
  j["overlap"] = result.overlap;
  j["worst_residual"] = result.worst_residual;
  j["newton_order"] = result.newton_order;
  if (scene.exact && result.end == RunResult::End::Done) {
    const auto e = problem::error_norms(model, problem::make_field(*scene.exact, model.constants(0), model.origin),
                                        stepper.state().load, stepper.state().displacement);
    j["error"] = {{"l2", e.l2},
                  {"l2_relative", e.l2 / e.l2_exact},
                  {"energy", e.energy},
                  {"energy_relative", e.energy / e.energy_exact}};
  }
  for (const auto& point : result.critical)
    j["critical_points"].push_back(
        {{"kind", name_of(point.kind)}, {"before", point.before}, {"load", point.load}, {"step", point.step}});
  if (grows(scene)) j["growth"] = grown(evolution);
  j["remarks"] = notes;
  for (const auto& remark : result.remarks) j["remarks"].push_back(remark);
  j["scene"] = nlohmann::ordered_json::parse(scene::to_json(scene));
  return j;
}

// Nothing where the file is no longer there: what has been lost is told already.
std::vector<results::CriticalPoint> critical_of(const std::string& history) {
  try {
    return results::critical_points(results::read_csv(history));
  } catch (const std::runtime_error&) {
    return {};
  }
}

std::string remark_on(const growth::Advance& a, const assembly::Model& model, double load) {
  const std::string tip =
      fmt::format("crack '{}', {}", model.cracks[a.tip.crack].name, a.tip.end == 0 ? "start" : "end");
  if (a.length == 0.0) return fmt::format("{}: no advance at load {:.6g}: {}", tip, load, a.hindrance);
  std::string out = fmt::format("{}: advance {} at load {:.6g} to {}, turned by {:.1f} degrees", tip, a.number, load,
                                model.words_for(a.point), a.turn * 180.0 / std::numbers::pi);
  if (a.stop == growth::Stop::Boundary) out += "; it cuts through the boundary";
  if (a.stop == growth::Stop::Hindered) out += "; no farther: " + a.hindrance;
  return out;
}

}  // namespace

RunResult run(const problem::Specification& scene, const RunOptions& options) {
  set_blas_threads(options.threads);
  double total = 0.0;
  const PhaseTimer clock(total);
  Seconds seconds;
  assembly::Model model;
  {
    const PhaseTimer timer(seconds.cut);
    model = build_model(scene);
  }
  const std::string checkpoint_path = options.directory + "/checkpoint";
  results::Checkpoint kept;
  if (options.resume && !std::filesystem::exists(checkpoint_path))
    (void)results::read_bytes(checkpoint_path);  // makes no folder
  const RunFolder folder(options.directory);
  std::string of_folder;
  if (options.resume)
    kept = read_checkpoint(scene, checkpoint_path);
  else
    of_folder = remove_results(options.directory);
  seconds.before = kept.seconds;
  if (options.remark && !of_folder.empty()) options.remark(of_folder);
  const auto notes = remarks(scene, model);
  if (options.remark)
    for (const auto& note : notes) options.remark(note);
  growth::Evolution evolution = growth::Evolution(scene, std::move(model));
  if (options.resume) evolution.restore(kept.growth, kept.state, kept.place, kept.room);
  results::Results results(scene, options.directory, options.resume ? &kept : nullptr);
  const auto state = [&]() -> const assembly::State& { return evolution.stepper().state(); };

  RunResult result;
  result.increments = kept.place.number;
  result.iterations = kept.iterations;
  result.cuts = kept.cuts;
  result.worst_residual = kept.worst_residual;
  result.rounded = kept.rounded;
  result.jumps = kept.jumps;
  result.load = state().load;
  result.energies = state().energies;
  const double load_before = state().load;
  std::vector<double> orders;
  Progress progress;
  const auto tell = [&](int iteration, double residual) {
    if (!options.observer) return;
    progress.load = state().load;
    progress.increment = static_cast<int>(result.increments) + (iteration > 0);
    progress.iteration = iteration;
    progress.residual = residual;
    progress.iterations = result.iterations;
    progress.cuts = result.cuts;
    progress.elapsed = clock.seconds();
    const double covered = progress.load - load_before;
    progress.rest = covered > 0.0 ? progress.elapsed * (1.0 - progress.load) / covered : 0.0;
    options.observer(progress);
  };

  const auto keep = [&] {
    const auto& stepper = evolution.stepper();
    const results::Checkpoint now{scene::solved_json(scene),
                                  stepper.state(),
                                  stepper.place(),
                                  stepper.assembler().room(),
                                  evolution.record(),
                                  result.iterations,
                                  result.cuts,
                                  result.worst_residual,
                                  result.rounded,
                                  result.jumps,
                                  kept.seconds + clock.seconds(),
                                  results.log_bytes(),
                                  results.outputs()};
    results::write_atomically(checkpoint_path, to_bytes(now));
  };
  if (!options.resume) keep();  // so that a later run knows the files of this one even if nothing converges

  while (!evolution.done()) {
    if (options.stop && *options.stop) {
      result.end = RunResult::End::Stopped;
      break;
    }
    const auto outcome = evolution.advance([&](int i, const solve::Iteration& it) { tell(i, it.residual); });
    if (const auto* failure = std::get_if<assembly::Failure>(&outcome)) {
      result.end = RunResult::End::Failed;
      result.failure = *failure;
      result.reason = describe(*failure, evolution.model());
      result.advice = advice(*failure, evolution.model());
      break;
    }
    const auto& step = std::get<growth::Step>(outcome);
    const RunResult saved = result;
    result.increments = step.number;
    result.iterations += static_cast<long>(step.iterations.size()) + step.iterations_before;
    result.cuts += step.cuts;
    result.worst_residual = std::max(result.worst_residual, step.left.residual);
    count(step, result.rounded);
    if (step.jumped && result.jumps.increments++ == 0) result.jumps.load = step.load;
    auto residuals = step.iterations;
    residuals.push_back(step.left);
    if (const auto seen = solve::convergence_order(residuals); seen && !seen->at_least) orders.push_back(seen->order);
    const auto& pairs = evolution.stepper().pairs();
    progress.contact_points = static_cast<int>(std::count_if(pairs.begin(), pairs.end(), contact::presses));
    try {
      const PhaseTimer timer(seconds.write);
      results.add_step(step, evolution.stepper());
      if (scene.loading.every_step || step.is_output) results.add_fields(step, evolution.stepper());
      keep();
    } catch (const std::runtime_error& error) {
      result = saved;  // what the last checkpoint holds
      result.end = RunResult::End::NotWritten;
      result.unwritten = error.what();
      break;
    }
    result.load = state().load;
    result.energies = state().energies;
    tell(0, step.left.residual);
    if (options.remark)
      for (const auto& advance : step.advances) options.remark(remark_on(advance, evolution.model(), step.load));
  }

  for (const auto& tips : evolution.record().tips) result.advances += tips[0].advances + tips[1].advances;
  const auto& surfaces = evolution.model().surfaces;
  if (!surfaces.points.empty()) result.overlap = state().history.deepest / surfaces.element_size;
  result.newton_order = median(orders);
  if (scene.loading.control == solve::Control::Path) result.critical = critical_of(results.path("history.csv"));
  result.remarks = remarks_at_end(scene, evolution.stepper(), result.jumps);
  for (auto& remark : remarks_on_rounding(result.rounded, evolution.stepper()))
    result.remarks.push_back(std::move(remark));
  for (auto& remark : remarks_on_growth(scene, evolution.record())) result.remarks.push_back(std::move(remark));
  if (result.advances > 0)
    for (auto& remark : remarks_on_reach(scene, evolution.model(), false)) result.remarks.push_back(std::move(remark));
  const auto solver = evolution.solver_seconds();
  result.yardstick = solver.factorise + solver.solve;
  const auto assembly = evolution.assembly_seconds();
  result.phases = {{"cut", seconds.cut},          {"assembly", assembly.bulk}, {"contact", assembly.contact},
                   {"pattern", assembly.pattern}, {"analyse", solver.analyse}, {"factorise", solver.factorise},
                   {"solve", solver.solve},       {"write", seconds.write}};
  const auto evaluations = static_cast<double>(std::max(1L, assembly.assemblies));
  result.bulk_microseconds =
      1e6 * assembly.bulk / (evaluations * static_cast<double>(evolution.model().material_points()));
  if (!surfaces.points.empty())
    result.contact_microseconds = 1e6 * assembly.contact / (evaluations * static_cast<double>(surfaces.points.size()));
  result.peak_megabytes = peak_megabytes();
  result.seconds = clock.seconds();
  try {
    results::write_atomically(results.path("run.json"),
                              summary(scene, evolution, result, seconds, notes)
                                      .dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) +
                                  "\n");
  } catch (const std::runtime_error& error) {
    result.end = RunResult::End::NotWritten;
    result.unwritten = error.what();
  }
  return result;
}

}  // namespace cleft::simulation
