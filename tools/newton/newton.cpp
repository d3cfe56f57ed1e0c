// cleft newton: the order of convergence of the iterations of a run.
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <span>

#include "cleft/scene/read.hpp"
#include "cleft/simulation/run.hpp"
#include "cleft/tangent_check/newton_rate.hpp"
#include "verbs.hpp"

namespace cleft::tools {
namespace {

struct Options {
  std::string subject;  // folder of a run, or a scene
  std::string directory;
  std::vector<std::string> overrides;
  tangent_check::RateRequirement required;
  bool all = false;
};

std::string order_of(const tangent_check::ObservedRate& rate) {
  if (rate.order) return fmt::format("{}{:.2f}", rate.is_bound ? ">= " : "", *rate.order);
  return rate.at_unit_scale ? fmt::format("- (at unit scale {:.2f})", *rate.at_unit_scale) : "-";
}

// What is farthest from balance at the last iteration that made a correction above rounding.
std::string slowest(const tangent_check::IncrementRate& rate) {
  using At = solve::LargestResidual::At;
  const auto clear = [](const solve::Iteration& it) {
    return it.residual > it.rounding && it.largest.at != At::Nowhere;
  };
  const auto last = std::find_if(rate.iterations.rbegin(), rate.iterations.rend(), clear);
  if (last == rate.iterations.rend()) return {};
  const auto& [at, place] = last->largest;
  const char* what = at == At::Contact ? "contact point"
                     : at == At::Flow  ? "plastic point"
                     : at == At::Tip   ? "branch functions of the tip"
                                       : "node";
  return fmt::format("{} at ({:.6g}, {:.6g})", what, place.x(), place.y());
}

std::string evidence(const tangent_check::IncrementRate& rate) {
  std::string text = fmt::format("  increment {:4}  load {:8.5f}{}  order {}   residual/gradient of the correction",
                                 rate.step, rate.load, rate.failed ? "  failed" : "", order_of(rate.rate));
  constexpr std::size_t kMost = 12;  // the last ones; failed attempts may have a hundred
  const std::size_t first = rate.iterations.size() - std::min(rate.iterations.size(), kMost);
  if (first > 0) text += " ...";
  for (const auto& it : std::span(rate.iterations).subspan(first))
    text += fmt::format(" {:.1e}/{:.1e}{}", it.residual, it.gradient, it.switches() ? "*" : "");
  const std::string where = slowest(rate);
  return where.empty() ? text : text + "   slowest: " + where;
}

void list(const char* title, const std::vector<tangent_check::IncrementRate>& rates, bool all) {
  constexpr std::size_t kMost = 10;
  if (rates.empty()) return;
  fmt::print("{}:\n", title);
  const std::size_t shown = all ? rates.size() : std::min(rates.size(), kMost);
  for (std::size_t k = 0; k < shown; ++k) fmt::print("{}\n", evidence(rates[k]));
  if (shown < rates.size()) fmt::print("  and {} more (--all lists them)\n", rates.size() - shown);
}

void print_counts(const tangent_check::RateVerdict& v, const Options& options) {
  using tangent_check::Finding;
  const auto line = [&](Finding finding, const std::string& text) {
    if (v.of(finding) > 0) fmt::print("{:6} {}\n", v.of(finding), text);
  };
  fmt::print("increments {}, judged {}", v.increments, v.judged());
  if (v.failed > 0) fmt::print(", attempts that failed {}", v.failed);
  fmt::print("\n");
  line(Finding::Order, fmt::format("of order {:.4g} or more", options.required.order));
  line(Finding::Constant, "with g+/g^2 bounded while g+/g falls (g: gradient of the correction)");
  line(Finding::Linear, "linear: a step leaves less than 1e-6 of the correction");
  line(Finding::Missed, "below the order");
  line(Finding::UnitScale, "over after two corrections, the second as small as that order makes it (no miss can show)");
  line(Finding::AtRounding, "begin so near rounding that nothing can show");
  line(Finding::Unknown, "not judged: rounding comes too soon, or contact and flow settle too late");
}

void print(const tangent_check::RateVerdict& v, const Options& options) {
  print_counts(v, options);
  if (v.orders.back() > 0.0)
    fmt::print("order: lowest {:.2f}, quartiles {:.2f}, {:.2f}, {:.2f}, highest {:.2f}\n", v.orders[0], v.orders[1],
               v.orders[2], v.orders[3], v.orders[4]);
  if (v.sharpest)
    fmt::print("smallest ratio of corrections {:.1e}: smaller errors of the tangent do not show\n", *v.sharpest);
  list("below the order (* after a change of partner, status or flow)", v.missed, options.all);
  if (options.all) list("not judged", v.unknown, true);
}

// The last attempts of a run that failed.
void print_failure(const std::vector<tangent_check::IncrementRate>& rates) {
  std::size_t first = rates.size();
  while (first > 0 && rates[first - 1].failed) --first;
  if (first == rates.size()) return;
  fmt::print("the last of the attempts that failed in the end:\n{}\n", evidence(rates.back()));
}

// A folder that is gone with this object.
struct TemporaryFolder {
  std::string path = (std::filesystem::temp_directory_path() / "cleft-newton-XXXXXX").string();
  TemporaryFolder() {
    if (!mkdtemp(path.data())) throw std::runtime_error(path + ": a temporary folder cannot be made");
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }
};

std::vector<solve::Iteration> iterations_of(const solve::Step& step) {
  auto out = step.iterations;
  out.push_back(step.left);
  return out;
}

// What a run cannot write, as on a full disk.
struct NotWritten : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Solves a scene until it ends, fails or is clearly linear.
std::vector<tangent_check::IncrementRate> rates_of_scene(const Options& options) {
  const auto scene = tangent_check::until_rounding(scene::read_scene(options.subject, options.overrides));
  const TemporaryFolder temporary;
  std::atomic<bool> stop = false;
  std::vector<tangent_check::IncrementRate> rates;
  simulation::RunOptions run;
  run.directory = options.directory.empty() ? temporary.path : options.directory;
  run.stop = &stop;
  run.step = [&](const solve::Step& step) {
    const auto iterations = iterations_of(step);
    rates.push_back({step.number, step.load, false, iterations, tangent_check::observe(iterations)});
    if (tangent_check::is_clearly_linear(rates, options.required)) stop = true;
  };
  const auto result = simulation::run(scene, run);
  using End = simulation::RunResult::End;
  if (result.end == End::NotWritten) throw NotWritten(result.unwritten);
  if (result.end == End::Failed) fmt::print("the run ended at load {:.6g}: {}\n", result.load, result.reason);
  if (result.end == End::Stopped)
    fmt::print("stopped at load {:.6g}: the last increments are clearly linear\n", result.load);
  return tangent_check::newton_rates(run.directory);
}

int newton(const Options& options) try {
  using tangent_check::RateAnswer;
  const bool is_folder = std::filesystem::is_directory(options.subject);
  if (is_folder && !(options.overrides.empty() && options.directory.empty()))
    throw std::runtime_error(options.subject +
                             ": the folder of a run, which is only read; --set and -o go with a scene");
  const auto rates = is_folder ? tangent_check::newton_rates(options.subject) : rates_of_scene(options);
  const auto verdict = tangent_check::judge(rates, options.required);
  print(verdict, options);
  print_failure(rates);
  switch (verdict.answer) {
    case RateAnswer::Holds:
      return kDone;
    case RateAnswer::Misses:
      fmt::print("does not hold: {}\n", verdict.reason);
      return kCheckFailed;
    case RateAnswer::Unknown:
      fmt::print("cannot tell: {}\n", verdict.reason);
  }
  return kCannotTell;
} catch (const NotWritten& error) {
  fmt::print(stderr, "cleft: {}\n", error.what());
  return kFailed;
}

}  // namespace

void add_newton(CLI::App& app, int& result) {
  auto options = std::make_shared<Options>();
  auto* verb = app.add_subcommand("newton", "order of convergence of a run's iterations");
  verb->add_option("subject", options->subject, "folder of a run, or a scene, which is then solved until rounding")
      ->required();
  verb->add_option("-o,--output", options->directory, "folder for the run of a scene; default: a temporary one");
  verb->add_option("--set", options->overrides, "overrides a key of the scene; may be repeated")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  verb->add_option("--order", options->required.order, "order that increments must show")
      ->check(CLI::Range(0.0, 10.0))
      ->capture_default_str();
  verb->add_option("--share", options->required.share, "share of the judged increments that must show it")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  verb->add_option("--least", options->required.least, "order that none may fall short of")
      ->check(CLI::Range(0.0, 10.0))
      ->capture_default_str();
  verb->add_flag("--all", options->all, "list all increments that miss, and those that cannot be judged");
  verb->callback([options, &result] { result = newton(*options); });
}

}  // namespace cleft::tools
