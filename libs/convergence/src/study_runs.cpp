#include "study_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <nlohmann/json.hpp>
#include <numeric>

#include "cleft/convergence/run_cache.hpp"
#include "cleft/support/files.hpp"
#include "cleft/support/process.hpp"
#include "parallel.hpp"

namespace cleft::convergence {
namespace {

constexpr int kSolutionFailed = 3;  // exit code of `cleft run`

// What a program wrote last: a line, with those that it is folded into.
std::string last_words(const std::string& log) {
  std::ifstream in(log);
  std::string out;
  for (std::string line; std::getline(in, line);) {
    if (line.find_first_not_of(' ') == std::string::npos) continue;
    const bool goes_on = line.front() == ' ';
    line.erase(0, line.find_first_not_of(' '));
    out = goes_on && !out.empty() ? out + " " + line : line;
  }
  return out;
}

// Why a run that ended with this exit code did not reach its end, in its own words.
std::string why(const std::string& folder, int code) {
  if (code == kSolutionFailed) try {
      const auto json = nlohmann::json::parse(read_bytes(folder + "/run.json"));
      if (json.contains("failure"))
        return fmt::format("failed at load {:.6g}: {}", json.at("load").get<double>(),
                           json.at("failure").get<std::string>());
    } catch (const std::exception&) {  // then the log tells
    }
  const std::string words = last_words(folder + ".log");
  return words.empty() ? "it was killed or could not be started" : words;
}

class Runner {
 public:
  Runner(const scene::Study& study, const StudyOptions& options, const Task& task, StudyRun& run)
      : study_(study), options_(options), task_(task), run_(run) {}

  void bring_to_its_end() {
    run_.reused = is_sealed(run_.folder);
    try {
      if (!run_.reused) solve();
      if (run_.failure.empty()) take_timings();
    } catch (const std::exception& error) {
      run_.failure = error.what();
    }
  }

 private:
  void solve();
  void take_timings();
  int call_program(const std::string& folder, bool resume) const;

  const scene::Study& study_;
  const StudyOptions& options_;
  const Task& task_;
  StudyRun& run_;
};

int Runner::call_program(const std::string& folder, bool resume) const {
  std::vector<std::string> command{
      options_.program, "run", study_.scene, "--output", folder, "--until", fmt::format("{}", task_.last_load)};
  for (const auto& o : task_.overrides) command.insert(command.end(), {"--set", o});
  if (resume) command.emplace_back("--resume");
  return call(command, folder + ".log");
}

// Goes on from what is there; what cannot be gone on from is run anew.
void Runner::solve() {
  bool resumed = is_resumable(run_.folder);
  int code = resumed ? call_program(run_.folder, true) : 0;
  if (!resumed || (code != 0 && code != kSolutionFailed)) {
    resumed = false;
    std::filesystem::remove_all(run_.folder);
    code = call_program(run_.folder, false);
  }
  if (code != 0) {
    run_.failure = fmt::format("exit code {}: {}; see {}.log", code, why(run_.folder, code), run_.folder);
    return;
  }
  Timing timing = timing_of(run_.folder, options_.jobs);
  if (resumed) timing.phases.clear();  // those of the last part only
  write_timings(run_.folder, {timing});
  seal(run_.folder);
}

// Of the timings with as many jobs as now where there are any, else of those that there are.
void Runner::take_timings() {
  auto all = read_timings(run_.folder);
  const auto of_now = [&](const Timing& t) { return t.jobs == options_.jobs; };
  auto missing = options_.repeats - std::ranges::count_if(all, of_now);
  if (options_.repeats == 1 && !all.empty()) missing = 0;
  const std::string again = run_.folder + "_again";
  for (; missing > 0; --missing) {
    std::filesystem::remove_all(again);
    if (const int code = call_program(again, false); code != 0)
      throw std::runtime_error(fmt::format("timed again: exit code {}: {}", code, why(again, code)));
    all.push_back(timing_of(again, options_.jobs));
    write_timings(run_.folder, all);
    seal(run_.folder);
    std::filesystem::remove_all(again);
    std::filesystem::remove(again + ".log");
  }
  if (std::ranges::any_of(all, of_now)) std::erase_if(all, std::not_fn(of_now));
  const auto [least, most] = std::ranges::minmax(all, {}, &Timing::seconds);
  const Timing middle = median(all);
  run_.jobs = middle.jobs;
  run_.timings = static_cast<int>(all.size());
  run_.seconds = middle.seconds;
  run_.seconds_spread = most.seconds - least.seconds;
  run_.phases = middle.phases;
}

}  // namespace

void run_all(const scene::Study& study, const StudyOptions& options, Plan& plan) {
  std::vector<std::size_t> order(plan.tasks.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto work = [&](std::size_t i) {
    return static_cast<double>(plan.runs[i].unknowns) * plan.tasks[i].scene.loading.steps;
  };
  std::ranges::stable_sort(order, std::greater(), work);  // the longest run must not start last
  std::mutex one;
  for_each_parallel(order.size(), options.jobs, [&](std::size_t k) {
    StudyRun& run = plan.runs[order[k]];
    Runner(study, options, plan.tasks[order[k]], run).bring_to_its_end();
    const std::lock_guard lock(one);
    const char* const end = !run.failure.empty() ? "FAILED" : run.reused ? "was there" : "done";
    if (options.tell) options.tell(fmt::format("{} {}", title_of(run), end));
  });
}

}  // namespace cleft::convergence
