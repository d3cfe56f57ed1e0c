// cleft run: solves a scene.
#include "cleft/scene/run.hpp"

#include <fmt/format.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdio>

#include "cleft/scene/read.hpp"
#include "verbs.hpp"

namespace cleft::tools {
namespace {

std::atomic<bool> interrupted = false;

void on_interrupt(int) { interrupted = true; }

std::string duration(double seconds) {
  return seconds < 100 ? fmt::format("{:.1f} s", seconds) : fmt::format("{:.0f} min", seconds / 60);
}

void show(const scene::Progress& p, bool live) {
  const std::string line = fmt::format(
      "load {:7.4f}  increment {:4}  iterations {:5}  cuts {:2}  residual {:8.1e}  contact {:5}  {:>8}, {} to go",
      p.load, p.increment, p.iterations, p.cuts, p.residual, p.contact_points, duration(p.elapsed), duration(p.rest));
  if (live)
    fmt::print(stderr, "\r\x1b[K{}{}", line, p.iteration > 0 ? fmt::format("  it {}", p.iteration) : "");
  else if (p.iteration == 0)
    spdlog::info(line);
}

void print_summary(const scene::RunResult& r, const std::string& directory) {
  const double per_increment =
      r.increments > 0 ? static_cast<double>(r.iterations) / static_cast<double>(r.increments) : 0.0;
  fmt::print("increments {}, iterations {} ({:.2f} an increment), cuts {}, worst residual {:.1e}", r.increments,
             r.iterations, per_increment, r.cuts, r.worst_residual);
  if (r.newton_order > 0) fmt::print(", order {:.2f}", r.newton_order);
  if (r.advances > 0) fmt::print(", advances of tips {}", r.advances);
  const auto& e = r.energies;
  fmt::print(
      "\nenergy, J/m: external work {:.6g} = elastic {:.6g} + plastic {:.6g} + viscous {:.6g} + friction {:.6g} + "
      "contact {:.6g}{} + imbalance {:.2g} "
      "({:.4f} %)\n",
      e.external_work, e.elastic, e.plastic_dissipation, e.viscous_dissipation, e.friction_dissipation, e.contact,
      e.released != 0.0 ? fmt::format(" + released by growth {:.6g}", e.released) : "", e.imbalance(),
      e.external_work == 0.0 ? 0.0 : 100.0 * e.imbalance() / e.external_work);
  fmt::print("time {}, {:.2f} of iterations x (factorisation + solve); {:.2f} us a cell", duration(r.seconds),
             r.yardstick > 0 ? r.seconds / r.yardstick : 0.0, r.bulk_microseconds);
  if (r.contact_microseconds > 0) fmt::print(", {:.2f} us a contact point", r.contact_microseconds);
  fmt::print("; peak memory {:.0f} MB\nresults in {}: history.csv, {}fields.pvd, run.json\n", r.peak_megabytes,
             directory, r.advances > 0 ? "growth.csv, " : "");
}

struct Options {
  std::string scene;
  std::vector<std::string> overrides;
  scene::RunOptions run;
};

int solve(const Options& options) {
  const auto scene = scene::read_scene(options.scene, options.overrides);
  auto run = options.run;
  spdlog::set_default_logger(spdlog::stderr_color_mt("cleft"));
  spdlog::set_pattern("%T %^%l%$  %v");
  const bool live = isatty(STDERR_FILENO) != 0;
  run.observer = [live](const scene::Progress& p) { show(p, live); };
  run.remark = [](const std::string& text) { spdlog::info("note: {}", text); };
  run.stop = &interrupted;
  std::signal(SIGINT, on_interrupt);
  std::signal(SIGTERM, on_interrupt);
  const auto result = scene::run(scene, run);
  if (live) fmt::print(stderr, "\n");
  print_summary(result, run.directory);
  constexpr double kTooDeep = 0.1;
  if (result.overlap > kTooDeep)
    spdlog::warn("the crack's faces overlap by {:.2g} element sizes: the penalty is too soft for these loads",
                 result.overlap);
  if (result.end == scene::RunResult::End::Done) return kDone;
  const char* const go_on = result.increments > 0 ? "go on with --resume" : "run again";
  if (result.end == scene::RunResult::End::Stopped)
    spdlog::warn("interrupted at load {:.6g}; {}", result.load, go_on);
  else if (result.end == scene::RunResult::End::NotWritten)
    spdlog::error("stopped at load {:.6g}: {}; mend that and {}", result.load, result.unwritten, go_on);
  else
    spdlog::error("failed at load {:.6g}: {}; try {}", result.load, assembly::describe(result.failure),
                  result.failure.advice);
  return kFailed;
}

}  // namespace

void add_run(CLI::App& app, int& result) {
  auto options = std::make_shared<Options>();
  auto* verb = app.add_subcommand("run", "solve a scene");
  verb->add_option("scene", options->scene, "scene file (TOML)")->required();
  verb->add_option("-o,--output", options->run.directory, "folder for the results")->required();
  verb->add_option("--set", options->overrides, "KEY=VALUE overrides a key of the scene; may be repeated")
      ->allow_extra_args(false);
  verb->add_flag("--resume", options->run.resume, "go on from the last converged increment in the folder");
  verb->add_option("--threads", options->run.threads, "threads of the factorisation")->check(CLI::Range(1, 256));
  verb->callback([options, &result] { result = solve(*options); });
}

}  // namespace cleft::tools
