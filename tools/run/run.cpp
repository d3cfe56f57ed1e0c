// cleft run: solves a scene.
#include "cleft/simulation/run.hpp"

#include <fmt/format.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdio>

#include "cleft/scene/read.hpp"
#include "run/summary.hpp"
#include "text.hpp"
#include "verbs.hpp"

namespace cleft::tools {
namespace {

std::atomic<bool> interrupted = false;

void on_interrupt(int) { interrupted = true; }

// With the time before it a line of 80 columns.
const char* const kHead = "    load increment iterations cuts residual contact  elapsed    to go";

std::string line_of(const simulation::Progress& p) {
  return fmt::format("{:8.4f} {:9} {:10} {:4} {:8.1e} {:7} {:>8} {:>8}", p.load, p.increment, p.iterations, p.cuts,
                     p.residual, p.contact_points, duration(p.elapsed), duration(p.rest));
}

// Tells on stderr how a run goes: a line that is written over on a terminal, a line an increment elsewhere.
class Reporter {
 public:
  Reporter() {
    auto sink = std::make_shared<spdlog::sinks::stderr_color_sink_mt>();  // which colours a terminal only
    sink->set_color(spdlog::level::info, "");
    if (!takes_colour(STDERR_FILENO)) sink->set_color_mode(spdlog::color_mode::never);
    spdlog::set_default_logger(std::make_shared<spdlog::logger>("cleft", sink));
    spdlog::set_pattern("%T  %^%v%$");
  }
  void show(const simulation::Progress& p) {
    if (!headed_ && live_) fmt::print(stderr, "{}\n", kHead);
    if (!headed_ && !live_) spdlog::info(kHead);
    headed_ = true;
    under_way_ = live_;
    if (live_)
      fmt::print(stderr, "\r\x1b[K{}{}", line_of(p), p.iteration > 0 ? fmt::format("  it {}", p.iteration) : "");
    else if (p.iteration == 0)
      spdlog::info(line_of(p));
  }
  void say(spdlog::level::level_enum level, const std::string& text) {
    end_line();
    constexpr std::size_t kTime = 10;  // its columns
    spdlog::log(level, folded(text, kTime));
  }
  void end_line() {
    if (under_way_) fmt::print(stderr, "\n");
    under_way_ = false;
  }

 private:
  const bool live_ = isatty(STDERR_FILENO) != 0;
  bool headed_ = false, under_way_ = false;
};

struct Options {
  std::string scene;
  std::vector<std::string> overrides;
  simulation::RunOptions run;
};

int solve(const Options& options) {
  const auto scene = scene::read_scene(options.scene, options.overrides);
  auto run = options.run;
  Reporter reporter;
  run.observer = [&](const simulation::Progress& p) { reporter.show(p); };
  run.remark = [&](const std::string& text) { reporter.say(spdlog::level::info, "note: " + text); };
  run.stop = &interrupted;
  std::signal(SIGINT, on_interrupt);
  std::signal(SIGTERM, on_interrupt);
  const auto result = simulation::run(scene, run);
  reporter.end_line();
  print_summary(scene, result, run.directory);
  if (result.end == simulation::RunResult::End::Done) return kDone;
  const char* const go_on = result.increments > 0 ? "go on with --resume" : "run again";
  if (result.end == simulation::RunResult::End::Stopped)
    reporter.say(spdlog::level::warn, fmt::format("interrupted at load {:.6g}; {}", result.load, go_on));
  else if (result.end == simulation::RunResult::End::NotWritten)
    reporter.say(spdlog::level::err,
                 fmt::format("stopped at load {:.6g}: {}; mend that and {}", result.load, result.unwritten, go_on));
  else
    reporter.say(spdlog::level::err,
                 fmt::format("failed at load {:.6g}: {}; try {}", result.load, result.reason, result.advice));
  return kFailed;
}

}  // namespace

void add_run(CLI::App& app, int& result) {
  auto options = std::make_shared<Options>();
  auto* verb = app.add_subcommand("run", "solve a scene");
  verb->add_option("scene", options->scene, "scene file (TOML)")->required();
  verb->add_option("-o,--output", options->run.directory, "folder for the results")->required();
  verb->add_option("--set", options->overrides, "overrides a key of the scene; may be repeated")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  verb->add_flag("--resume", options->run.resume, "go on from the last converged increment in the folder");
  verb->add_option("--until", options->run.last_load, "ends with the first increment that reaches this load")
      ->type_name("LOAD")
      ->check(CLI::Range(0.0, 1.0));
  verb->add_option("--threads", options->run.threads, "threads of the factorisation")->check(CLI::Range(1, 256));
  verb->callback([options, &result] { result = solve(*options); });
}

}  // namespace cleft::tools
