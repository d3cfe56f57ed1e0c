// cleft tangent: the assembled tangent against differences of the assembled forces, along a real run.
#include "cleft/verify/tangent.hpp"

#include <fmt/format.h>

#include "cleft/scene/problem.hpp"
#include "cleft/scene/read.hpp"
#include "verbs.hpp"

namespace cleft::tools {
namespace {

struct Options {
  std::string scene;
  std::vector<std::string> overrides;
  int states = 5;
  double tolerance = 1e-6;
};

void print(const assembly::Model& model, const std::string& name, const verify::TangentBlock& block) {
  const auto& w = block.worst;
  fmt::print("{:44} {:>9} {:>9.1e}   load {:.4g}: {:.8g} assembled, {:.8g} by differences\n", name, block.entries,
             w.error(), w.load, w.exact, w.difference);
  fmt::print("{:66}force {}\n{:66}by displacement {}\n", "", verify::describe_component(model, w.row), "",
             verify::describe_component(model, w.column));
}

int tangent(const Options& options) {
  const auto scene = scene::read_scene(options.scene, options.overrides);
  const auto model = scene::build_model(scene);
  assembly::LoadStepper stepper(model, scene::step_controls(scene));
  verify::TangentReport report;
  // A third of an increment ahead: in the converged state itself each point that slides sits between stick and slip.
  constexpr double kAhead = 0.37;
  for (int k = 1; k <= options.states && !stepper.done(); ++k) {
    while (stepper.state().load < static_cast<double>(k) / options.states - 1e-9) {
      const auto outcome = stepper.advance();
      if (const auto* failure = std::get_if<assembly::Failure>(&outcome)) {
        fmt::print(stderr, "the run failed: {}; try {}\n", assembly::describe(*failure), failure->advice);
        return kFailed;
      }
    }
    const auto& s = stepper.state();
    const VecX ahead = s.displacement + kAhead * (s.displacement - s.previous_displacement);
    verify::check_tangent(model, s, ahead, options.tolerance, report);
  }
  fmt::print("{} states along the run; differences over the largest entry of the same part in the row\n\n",
             report.states);
  fmt::print("{:44} {:>9} {:>9}   {}\n", "block", "entries", "worst", "where");
  for (const auto& [name, block] : report.blocks) print(model, name, block);
  if (report.inconsistent.entries > 0) print(model, "two sizes of the step disagree", report.inconsistent);
  if (report.kinks > 0) {
    fmt::print("\nleft out on kinks of the law: {} entries", report.kinks);
    for (const auto& [reason, points] : report.kink_points) fmt::print("; {}: {} points", reason, points);
    fmt::print("\n");
  }
  const bool holds = report.worst() < options.tolerance;
  fmt::print("\nworst {:.1e}, {} {:.1e}\n", report.worst(), holds ? "below" : "NOT below", options.tolerance);
  return holds ? kDone : kCheckFailed;
}

}  // namespace

void add_tangent(CLI::App& app, int& result) {
  auto options = std::make_shared<Options>();
  auto* verb = app.add_subcommand("tangent", "compare the tangent with differences of the forces along a run");
  verb->add_option("scene", options->scene, "scene file (TOML)")->required();
  verb->add_option("--set", options->overrides, "KEY=VALUE overrides a key of the scene; may be repeated")
      ->allow_extra_args(false);
  verb->add_option("--states", options->states, "how many states, evenly over the load")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  verb->add_option("--tolerance", options->tolerance, "largest difference allowed")->capture_default_str();
  verb->callback([options, &result] { result = tangent(*options); });
}

}  // namespace cleft::tools
