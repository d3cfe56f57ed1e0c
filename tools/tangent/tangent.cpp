// cleft tangent: the tangent against differences of the forces, along a real run.
#include "cleft/tangent_check/tangent.hpp"

#include <fmt/format.h>

#include "cleft/problem/build.hpp"
#include "cleft/scene/read.hpp"
#include "cleft/simulation/failure_words.hpp"
#include "cleft/tangent_check/intermediate_states.hpp"
#include "verbs.hpp"

namespace cleft::tools {
namespace {

struct Options {
  std::string scene;
  std::vector<std::string> overrides;
  int states = 5;
  double tolerance = 1e-6;
};

void print_blocks(const tangent_check::TangentReport& report) {
  fmt::print("{:22}{:>10}{:>12}{:>10}{:>12}{:>14}{:>10}\n", "block", "pieces", "entries", "left out", "worst",
             "uncertainty", "at load");
  for (const auto& [name, block] : report.blocks) {
    const auto& w = block.worst;
    fmt::print("{:22}{:>10}{:>12}{:>10}{:>12.1e}{:>14.1e}{:>10.4g}\n", name, block.pieces, block.entries,
               block.left_out, w.error(), w.scale > 0.0 ? w.uncertainty / w.scale : 0.0, w.load);
  }
}

// Where things were found, in words: the model that their numbers belong to is gone once cracks have grown.
struct Places {
  std::map<std::string, std::string> worst;  // by block
  std::vector<std::string> kinks;

  void add(const assembly::Model& model, double load, const tangent_check::TangentReport& report) {
    for (const auto& [name, block] : report.blocks) {
      const auto& w = block.worst;
      if (w.error() == 0.0 || w.load != load) continue;
      worst[name] = fmt::format(
          "{}\n    {:.10g} assembled, {:.10g} by differences\n    force {}\n    by displacement {}",
          tangent_check::describe_piece(model, w.cell, w.point), w.exact, w.difference,
          tangent_check::describe_component(model, w.row), tangent_check::describe_component(model, w.column));
    }
    for (std::size_t k = kinks.size(); k < report.kinks.size(); ++k)
      kinks.push_back(tangent_check::describe_piece(model, report.kinks[k].cell, report.kinks[k].point));
  }
};

void print_worst(const Places& places) {
  fmt::print("\nworst entries, N/m^2\n");
  for (const auto& [name, place] : places.worst) fmt::print("  {}: {}\n", name, place);
}

void print_kinks(const Places& places, const tangent_check::TangentReport& report) {
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

int verdict(const tangent_check::TangentReport& report, double tolerance) {
  if (!(report.worst() < tolerance)) {
    fmt::print("\ndoes not hold: worst {:.1e}, NOT below {:.1e}\n", report.worst(), tolerance);
    return kCheckFailed;
  }
  if (!report.enough()) {
    fmt::print("\ndoes not hold: too little could be judged to {:.1e}\n", tolerance);
    return kCheckFailed;
  }
  fmt::print("\nworst {:.1e}, below {:.1e}\n", report.worst(), tolerance);
  return kDone;
}

int tangent(const Options& options) {
  const auto scene = scene::read_scene(options.scene, options.overrides);
  auto body = growth::Evolution(scene, problem::build_model(scene));
  Places places;
  tangent_check::TangentReport report;
  std::optional<assembly::Failure> no_forces;
  // The run behind a wrong tangent is not worth waiting for.
  const auto failure = tangent_check::visit_intermediate_states(
      body, options.states, [&](const tangent_check::IntermediateState& between) {
        no_forces = tangent_check::check_tangent(between.model, between.before.history, between.displacement,
                                                 between.load, options.tolerance, report);
        places.add(between.model, between.load, report);
        return !no_forces && report.worst() < options.tolerance;
      });
  fmt::print("{} states between converged ones; differences over the largest entry of the same piece in the row\n\n",
             report.states);
  print_blocks(report);
  print_worst(places);
  print_kinks(places, report);
  for (const auto& reason : {failure, no_forces})
    if (reason)
      fmt::print(stderr, "the run failed: {}; try {}\n", simulation::describe(*reason, body.model()),
                 simulation::advice(*reason, body.model()));
  const int held = verdict(report, options.tolerance);
  // a wrong tangent is a reason to fail
  return (failure || no_forces) && held == kDone ? kFailed : held;
}

}  // namespace

void add_tangent(CLI::App& app, int& result) {
  auto options = std::make_shared<Options>();
  auto* verb = app.add_subcommand("tangent", "compare the tangent with differences of the forces along a run");
  verb->add_option("scene", options->scene, "scene file (TOML)")->required();
  verb->add_option("--set", options->overrides, "overrides a key of the scene; may be repeated")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  verb->add_option("--states", options->states, "how many states, evenly over the load, at most one an increment")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  verb->add_option("--tolerance", options->tolerance, "largest difference allowed, relative to the row of its piece")
      ->check(CLI::Range(1e-9, 1.0))  // differences are no better
      ->capture_default_str();
  verb->callback([options, &result] { result = tangent(*options); });
}

}  // namespace cleft::tools
