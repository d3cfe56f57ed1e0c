// cleft tangent: the tangent against differences of the forces, along a real run.
#include "cleft/tangent_check/tangent.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "cleft/problem/build.hpp"
#include "cleft/scene/read.hpp"
#include "cleft/simulation/failure_words.hpp"
#include "cleft/tangent_check/survey.hpp"
#include "verbs.hpp"

namespace cleft::tools {
namespace {

using tangent_check::TangentReport;

struct Options {
  std::string scene;
  std::vector<std::string> overrides, required;
  tangent_check::SurveyControls controls;
};

void print_blocks(const TangentReport& report) {
  fmt::print("{:28}{:>10}{:>12}{:>10}{:>12}{:>14}{:>10}\n", "block", "pieces", "entries", "left out", "worst",
             "uncertainty", "at load");
  for (const auto& [name, block] : report.blocks) {
    const auto& w = block.worst;
    fmt::print("{:28}{:>10}{:>12}{:>10}{:>12.1e}{:>14.1e}{:>10.4g}\n", name, block.pieces, block.entries,
               block.left_out, w.error(), w.scale > 0.0 ? w.uncertainty / w.scale : 0.0, w.load);
  }
}

std::string place_of(const assembly::Model& model, const tangent_check::TangentKink& kink) {
  if (kink.cell == kNone && kink.point == kNone) return "the whole body";
  return tangent_check::describe_piece(model, kink.cell, kink.point);
}

// Where things were found, in words: the model that their numbers belong to is gone once cracks have grown.
struct Places {
  std::map<std::string, std::string> worst;  // by block
  std::vector<std::string> kinks;
  int states = 0;  // that have been seen
  void add(const assembly::Model& model, const TangentReport& report) {
    for (const auto& [name, block] : report.blocks) {
      const auto& w = block.worst;
      if (w.error() == 0.0 || w.state <= states) continue;
      worst[name] = fmt::format(
          "{}\n    {:.10g} assembled, {:.10g} by differences\n    force {}\n    by displacement {}",
          tangent_check::describe_piece(model, w.cell, w.point), w.exact, w.difference,
          tangent_check::describe_component(model, w.row), tangent_check::describe_component(model, w.column));
    }
    for (std::size_t k = kinks.size(); k < report.kinks.size(); ++k) kinks.push_back(place_of(model, report.kinks[k]));
    states = report.states;
  }
};

void print_worst(const Places& places) {
  fmt::print("\nworst entries, N/m^2\n");
  for (const auto& [name, place] : places.worst) fmt::print("  {}: {}\n", name, place);
}

void print_kinks(const Places& places, const TangentReport& report) {
  if (report.kinks.empty()) return;
  constexpr long kMost = 5;  // of each reason
  fmt::print("\nnot judged, or not in all entries\n");
  std::map<std::string, long> seen;
  for (std::size_t k = 0; k < report.kinks.size(); ++k) {
    const auto& kink = report.kinks[k];
    if (++seen[kink.reason] <= kMost) fmt::print("  load {:.4g}: {}: {}\n", kink.load, places.kinks[k], kink.reason);
  }
  for (const auto& [reason, number] : seen)
    if (number > kMost) fmt::print("  {}: {} in all\n", reason, number);
}

void print_taylor(const tangent_check::TaylorTest& taylor) {
  fmt::print("\nremainder of the residual, |R(u + e v) - R(u) - e K v|: {} states judged, {} not\n", taylor.states,
             taylor.unclear);
  if (taylor.states == 0) return;
  fmt::print("  least share of rows judged {:.0f} %\n", std::floor(100.0 * taylor.share));
  fmt::print("  lowest order in e {}, largest part of first order {:.1e} at load {:.4g}, force {}\n",
             std::isfinite(taylor.order) ? fmt::format("{:.2f}", taylor.order) : "unknown: all remainders are rounding",
             taylor.first_order, taylor.load, taylor.force);
}

void print_not_visited(const TangentReport& report) {
  const auto branches = report.not_visited();
  if (!branches.empty()) fmt::print("\nbranches of this scene that no state came to: {}\n", fmt::join(branches, ", "));
}

// A wrong tangent is a reason to fail.
int verdict(const TangentReport& report, bool failed, const Options& options) {
  const double tolerance = options.controls.tolerance, worst = std::fmax(report.worst(), report.taylor.first_order);
  if (!(worst < tolerance)) {
    fmt::print("\ndoes not hold: worst {:.1e}, NOT below {:.1e}\n", worst, tolerance);
    return kCheckFailed;
  }
  auto gaps = report.gaps();
  for (const auto& words : options.required)
    if (!report.has_judged(words)) gaps.push_back(fmt::format("required, but no state came to it: {}", words));
  if (failed) gaps.emplace_back("the run failed");
  if (!gaps.empty()) {
    fmt::print("\ncannot tell: too little could be judged to {:.1e}\n  {}\n", tolerance, fmt::join(gaps, "\n  "));
    return kCannotTell;
  }
  fmt::print("\nworst {:.1e}, below {:.1e}\n", worst, tolerance);
  return kDone;
}

// Cracks that grow may cut the body into branches that it does not have yet.
void check_required(const Options& options, const problem::Specification& scene, const assembly::Model& model) {
  if (problem::grows(scene)) return;
  const auto possible = tangent_check::possible_branches(model);
  for (const auto& words : options.required)
    if (!tangent_check::names_a_branch(possible, words))
      throw InputError(
          {options.scene}, "--require",
          fmt::format("no state of this scene comes to {}; its branches are {}", words, fmt::join(possible, ", ")));
}

int tangent(const Options& options) {
  const auto scene = scene::read_scene(options.scene, options.overrides);
  auto body = growth::Evolution(scene, problem::build_model(scene));
  check_required(options, scene, body.model());
  Places places;
  TangentReport report;
  const auto failure = tangent_check::survey(
      body, options.controls, report,
      [&](const tangent_check::IntermediateState& at, const TangentReport&) { places.add(at.model, report); });
  fmt::print("{} states between converged ones; differences over the largest entry of the same piece in the row\n\n",
             report.states);
  print_blocks(report);
  print_worst(places);
  print_kinks(places, report);
  print_taylor(report.taylor);
  print_not_visited(report);
  if (failure)
    fmt::print(stderr, "the run failed: {}; try {}\n", simulation::describe(*failure, body.model()),
               simulation::advice(*failure, body.model()));
  return verdict(report, failure.has_value(), options);
}

std::string is_branch(const std::string& words) {
  const auto branches = tangent_check::all_branches();
  if (tangent_check::names_a_branch(branches, words)) return {};
  return fmt::format("{} is on no branch; the words of branches are {}", words,
                     fmt::join(tangent_check::words_of(branches), ", "));
}

}  // namespace

void add_tangent(CLI::App& app, int& result) {
  auto options = std::make_shared<Options>();
  auto* verb = app.add_subcommand("tangent", "compare the tangent with differences of the forces along a run");
  verb->add_option("scene", options->scene, "scene file (TOML)")->required();
  verb->add_option("--set", options->overrides, "overrides a key of the scene; may be repeated")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  verb->add_option(
          "--states", options->controls.states,
          "how many states, evenly over the load, at most one an increment; where a new branch of a law is met "
          "come further ones")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  verb->add_option("--tolerance", options->controls.tolerance,
                   "largest difference allowed, relative to the row of its piece")
      ->check(CLI::Range(1e-9, 1.0))  // differences are no better
      ->capture_default_str();
  verb->add_option("--require", options->required,
                   "branches without which nothing is told (exit code 4), by words of their names: apex,stick; "
                   "'tip cone' asks for both words in one name; refused where the scene has none")
      ->delimiter(',')
      ->type_name("BRANCH")
      ->allow_extra_args(false)
      ->check(CLI::Validator(is_branch, ""));
  verb->callback([options, &result] { result = tangent(*options); });
}

}  // namespace cleft::tools
