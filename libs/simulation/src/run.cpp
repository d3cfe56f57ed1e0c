#include "cleft/simulation/run.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>

#include "cleft/problem/build.hpp"
#include "cleft/results/results.hpp"
#include "cleft/scene/json.hpp"
#include "cleft/simulation/contents.hpp"
#include "cleft/simulation/failure_words.hpp"
#include "cleft/simulation/remarks_before.hpp"
#include "cleft/support/timer.hpp"
#include "growth_remarks.hpp"
#include "machine.hpp"
#include "remarks_after.hpp"
#include "run_folder.hpp"
#include "summary.hpp"

namespace cleft::simulation {
namespace {

// Nothing where the file is no longer there: what has been lost is told already.
std::vector<results::CriticalPoint> critical_of(const std::string& history) {
  try {
    return results::critical_points(read_csv(history));
  } catch (const std::runtime_error&) {
    return {};
  }
}

class Run {
 public:
  Run(const problem::Specification& specification, const RunOptions& options)
      : scene_(specification), options_(options) {}

  void open();
  void advance_to_the_end();
  RunResult close();

 private:
  struct Seconds {
    double total = 0.0, before = 0.0;  // of this part of the run, and of those that it goes on from
    double cut = 0.0, write = 0.0;
  };

  assembly::Model build();
  std::optional<results::Checkpoint> take_folder();
  bool is_far_enough() const;
  bool advance();
  bool writes(const std::function<void()>& write);
  bool record_failed_attempts();
  bool record(const growth::Step& step);
  void keep(const results::Counts& counts);
  void look_at_state();
  void tell(int iteration, double residual);
  void say(const std::string& remark) const;
  void sum_up();
  void sum_up_seconds();
  void write_summary();

  const problem::Specification& scene_;
  const RunOptions& options_;
  Seconds seconds_;
  PhaseTimer clock_{seconds_.total};
  std::string solved_json_;
  std::vector<std::string> notes_;  // remarks before
  std::optional<RunFolder> folder_;
  std::optional<growth::Evolution> evolution_;
  std::optional<results::Results> results_;
  results::Counts counts_;  // of what the last checkpoint holds
  double first_load_ = 0.0;
  bool is_over_ = false;  // the run that is resumed has ended
  Progress progress_;
  RunResult result_;
};

void Run::open() {
  assembly::Model model = build();
  const auto kept = take_folder();
  notes_ = remarks_before(scene_, model);
  for (const auto& note : notes_) say(note);
  evolution_.emplace(scene_, std::move(model));
  if (kept) {
    evolution_->restore(kept->growth, kept->state, kept->place, kept->reserved);
    counts_ = kept->counts;
    seconds_.before = kept->seconds;
  }
  results_.emplace(contents_of(scene_), options_.directory, kept ? &*kept : nullptr);
  look_at_state();
  first_load_ = result_.load;
  if (!kept) keep(counts_);  // so that a later run knows the files of this one even if nothing converges
}

assembly::Model Run::build() {
  const PhaseTimer timer(seconds_.cut);
  return build_model(scene_);
}

// The checkpoint to go on from, if the run is to go on.
std::optional<results::Checkpoint> Run::take_folder() {
  solved_json_ = scene::solved_json(scene_);
  if (const auto checkpoint = RunFolder::checkpoint_file(options_.directory);
      options_.resume && !std::filesystem::exists(checkpoint))
    throw std::runtime_error(checkpoint + ": there is no run to go on with; run without --resume");
  folder_.emplace(options_.directory);
  if (options_.resume) return folder_->checkpoint_of(solved_json_);
  if (const auto told = folder_->remove_results(); !told.empty()) say(told);
  return std::nullopt;
}

void Run::advance_to_the_end() {
  is_over_ = options_.resume && (evolution_->done() || is_far_enough());
  if (is_over_) say(options_.directory + ": nothing is left to solve; its files stay as they are");
  while (!evolution_->done() && !is_far_enough() && advance()) {
  }
}

// Whether the last load is reached, and no tip still has to advance there.
bool Run::is_far_enough() const {
  constexpr double kRounding = 1e-12;
  return result_.load >= options_.last_load - kRounding && evolution_->record().pending.empty();
}

// One increment, or one step of growth; false where the run ends early.
bool Run::advance() {
  if (options_.stop && *options_.stop) {
    result_.end = RunResult::End::Stopped;
    return false;
  }
  const auto outcome = evolution_->advance([this](int i, const solve::Iteration& it) { tell(i, it.residual); });
  if (!record_failed_attempts()) return false;
  if (const auto* failure = std::get_if<assembly::Failure>(&outcome)) {
    result_.end = RunResult::End::Failed;
    result_.failure = *failure;
    result_.reason = describe(*failure, evolution_->model());
    result_.advice = advice(*failure, evolution_->model());
    return false;
  }
  const auto& step = std::get<growth::Step>(outcome);
  if (!record(step)) return false;
  if (options_.step) options_.step(step);
  look_at_state();
  progress_.contact_points = static_cast<int>(std::ranges::count_if(evolution_->stepper().pairs(), contact::presses));
  tell(0, step.left.residual);
  for (const auto& advance : step.advances) say(remark_on(advance, evolution_->model(), step.load));
  return true;
}

// False where what is to be written cannot be.
bool Run::writes(const std::function<void()>& write) {
  try {
    const PhaseTimer timer(seconds_.write);
    write();
    return true;
  } catch (const std::runtime_error& error) {
    result_.end = RunResult::End::NotWritten;
    result_.unwritten = error.what();
    return false;
  }
}

// Attempts that failed are part of what the next checkpoint holds; those at the end of a run that failed of nothing.
bool Run::record_failed_attempts() {
  const auto& attempts = evolution_->failed_attempts();
  if (attempts.empty()) return true;
  return writes([&] { results_->add_failed_attempts(static_cast<int>(counts_.increments) + 1, attempts); });
}

// Writes a step, with a checkpoint at the end of it; one that cannot be written does not count.
bool Run::record(const growth::Step& step) {
  results::Counts counts = counts_;
  counts.count(step);
  const bool written = writes([&] {
    results_->add_step(step, evolution_->stepper());
    if (scene_.loading.every_step || step.is_output) results_->add_fields(step, evolution_->stepper());
    keep(counts);
  });
  if (written) counts_ = std::move(counts);
  return written;
}

void Run::keep(const results::Counts& counts) {
  const auto& stepper = evolution_->stepper();
  const results::Checkpoint now{solved_json_,
                                stepper.state(),
                                stepper.place(),
                                stepper.assembler().reserved_couplings(),
                                evolution_->record(),
                                counts,
                                seconds_.before + clock_.seconds(),
                                results_->log_bytes(),
                                results_->outputs()};
  write_atomically(folder_->checkpoint_file(), to_bytes(now));
}

void Run::look_at_state() {
  const auto& stepper = evolution_->stepper();
  result_.load = stepper.state().load;
  result_.energies = stepper.state().energies;
}

void Run::tell(int iteration, double residual) {
  if (!options_.observer) return;
  progress_.load = evolution_->stepper().state().load;
  progress_.increment = static_cast<int>(counts_.increments) + (iteration > 0);
  progress_.iteration = iteration;
  progress_.residual = residual;
  progress_.iterations = counts_.iterations;
  progress_.cuts = counts_.cuts;
  progress_.elapsed = clock_.seconds();
  const double covered = progress_.load - first_load_;
  progress_.rest = covered > 0.0 ? progress_.elapsed * (options_.last_load - progress_.load) / covered : 0.0;
  options_.observer(progress_);
}

void Run::say(const std::string& remark) const {
  if (options_.remark) options_.remark(remark);
}

RunResult Run::close() {
  sum_up();
  sum_up_seconds();
  write_summary();
  return result_;
}

void Run::sum_up() {
  static_cast<results::Counts&>(result_) = counts_;
  result_.last_load = options_.last_load;
  result_.newton_order = counts_.median_order();
  result_.advances = advances_of(evolution_->record());
  const auto& surfaces = evolution_->model().surfaces;
  if (!surfaces.points.empty()) result_.overlap = evolution_->stepper().state().history.deepest / surfaces.element_size;
  if (scene_.loading.control == solve::Control::Path) result_.critical = critical_of(results_->path("history.csv"));
  result_.remarks = remarks_after(scene_, *evolution_, counts_);
}

void Run::sum_up_seconds() {
  const auto solver = evolution_->solver_seconds();
  const auto assembly = evolution_->assembly_seconds();
  result_.solver_seconds = solver.factorise + solver.solve;
  result_.phases = {{"cut", seconds_.cut},         {"assembly", assembly.bulk}, {"contact", assembly.contact},
                    {"pattern", assembly.pattern}, {"analyse", solver.analyse}, {"factorise", solver.factorise},
                    {"solve", solver.solve},       {"write", seconds_.write}};
  const auto& model = evolution_->model();
  const auto assemblies = static_cast<double>(std::max(1L, assembly.assemblies));
  const auto microseconds = [&](double seconds, std::size_t places) {
    return 1e6 * seconds / (assemblies * static_cast<double>(places));
  };
  result_.bulk_microseconds = microseconds(assembly.bulk, model.material_points());
  if (const auto points = model.surfaces.points.size(); points > 0)
    result_.contact_microseconds = microseconds(assembly.contact, points);
  result_.peak_megabytes = peak_megabytes();
  result_.seconds = clock_.seconds();
}

void Run::write_summary() {
  if (is_over_ && std::filesystem::exists(folder_->file("run.json"))) return;  // it knows the seconds of the phases
  try {
    write_atomically(folder_->file("run.json"),
                     summary(scene_, *evolution_, result_, seconds_.before + result_.seconds, notes_));
  } catch (const std::runtime_error& error) {
    result_.end = RunResult::End::NotWritten;
    result_.unwritten = error.what();
  }
}

}  // namespace

RunResult run(const problem::Specification& specification, const RunOptions& options) {
  set_blas_threads(options.threads);
  Run run(specification, options);
  run.open();
  run.advance_to_the_end();
  return run.close();
}

}  // namespace cleft::simulation
