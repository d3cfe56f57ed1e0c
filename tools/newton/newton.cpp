// cleft newton: the order of convergence of the iterations of a run.
#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <optional>

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

std::string evidence(const tangent_check::IncrementRate& rate) {
  std::string text = fmt::format("  increment {:4}  load {:8.5f}  order ", rate.step, rate.load);
  text += rate.order ? fmt::format("{}{:.2f}", rate.order->at_least ? ">= " : "", rate.order->order) : "-";
  if (!rate.order && rate.at_unit_scale) text += fmt::format(" (at unit scale {:.2f})", *rate.at_unit_scale);
  text += "   residual/gradient of the correction";
  for (const auto& it : rate.iterations)
    text += fmt::format(" {:.1e}/{:.1e}{}", it.residual, it.gradient,
                        it.partner_changes + it.status_changes > 0 ? "*" : "");
  return text;
}

void print(const tangent_check::RateVerdict& v, const Options& options) {
  fmt::print("increments {}, judged {}", v.increments, v.judged);
  if (v.judged > 0)
    fmt::print(
        " ({} by a lower bound), order {:.4g} or more in {} of them\norder: lowest {:.2f}, "
        "quartiles {:.2f}, {:.2f}, "
        "{:.2f}, highest {:.2f}",
        v.bounds, options.required.order, v.reach, v.orders[0], v.orders[1], v.orders[2], v.orders[3], v.orders[4]);
  fmt::print("\n");
  if (v.scaled > 0)
    fmt::print(
        "{} more are over after two corrections, the second as small as that order makes it (no miss can show)\n",
        v.scaled);
  if (!v.missed.empty()) fmt::print("below the order (* after a change of partner or status):\n");
  for (const auto& rate : v.missed) fmt::print("{}\n", evidence(rate));
  if (!v.unjudged.empty()) {
    fmt::print("not judged, the iteration reached rounding too soon or the contact settled too late: {}\n",
               options.all ? "" : fmt::format("{} increments (--all lists them)", v.unjudged.size()));
    for (const auto& rate : v.unjudged)
      if (options.all) fmt::print("{}\n", evidence(rate));
  }
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

// Nothing if the solution did not get to its end.
std::optional<std::vector<tangent_check::IncrementRate>> rates_of_scene(const Options& options) {
  const auto scene = tangent_check::until_rounding(scene::read_scene(options.subject, options.overrides));
  const TemporaryFolder temporary;
  simulation::RunOptions run;
  run.directory = options.directory.empty() ? temporary.path : options.directory;
  const auto result = simulation::run(scene, run);
  if (result.end != simulation::RunResult::End::Done) {
    const bool unwritten = result.end == simulation::RunResult::End::NotWritten;
    fmt::print(stderr, "the run ended at load {:.6g}: {}\n", result.load, unwritten ? result.unwritten : result.reason);
    return std::nullopt;
  }
  return tangent_check::newton_rates(run.directory);
}

int newton(const Options& options) {
  const bool is_folder = std::filesystem::is_directory(options.subject);
  if (is_folder && !(options.overrides.empty() && options.directory.empty()))
    throw std::runtime_error(options.subject +
                             ": the folder of a run, which is only read; --set and -o go with a scene");
  const auto rates = is_folder ? std::optional(tangent_check::newton_rates(options.subject)) : rates_of_scene(options);
  if (!rates) return kFailed;
  const auto verdict = tangent_check::judge(*rates, options.required);
  print(verdict, options);
  if (verdict.holds) return kDone;
  fmt::print("does not hold: {}\n",
             verdict.judged == 0 ? "no increment shows an order, all are over too soon; of a scene, which is solved "
                                   "until rounding, longer increments show it (fewer loading.steps)"
             : !verdict.enough
                 ? "fewer than half of the increments can be judged; longer ones show more (fewer loading.steps)"
             : verdict.lowest() < options.required.least
                 ? fmt::format("an order below {:.4g}", options.required.least)
                 : fmt::format("fewer than {:.0f} % reach the order", 100 * options.required.share));
  return kCheckFailed;
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
  verb->add_flag("--all", options->all, "list the increments that cannot be judged, too");
  verb->callback([options, &result] { result = newton(*options); });
}

}  // namespace cleft::tools
