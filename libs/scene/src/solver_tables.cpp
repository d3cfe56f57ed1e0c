// Increments, outputs and tolerances.
#include <fmt/format.h>

#include "tables.hpp"

namespace cleft::scene {
namespace {

using problem::LoadingSpec;
using problem::SolverSpec;

void check_outputs(const Section& s, LoadingSpec& loading) {
  loading.every_step = !s.has("outputs");
  const auto& loads = loading.outputs;
  for (std::size_t k = 0; k < loads.size(); ++k)
    if (loads[k] <= 0.0 || loads[k] > 1.0)
      s.fail_at("outputs", k,
                fmt::format("{} is no load; allowed: loads in (0, 1], of which 1 is the whole load", loads[k]));
    else if (k > 0 && loads[k] <= loads[k - 1])
      s.fail_at("outputs", k,
                fmt::format("{} follows {}; allowed: loads in (0, 1], each larger than the one before", loads[k],
                            loads[k - 1]));
}

// Errors of iteration stay small against the error of the increments that is asked for.
void residual_of_accuracy(const Section&, SolverSpec& solver) {
  solver.residual_tolerance = std::max(solver.residual_tolerance, 1e-3 * solver.accuracy);
}
void correction_of_accuracy(const Section&, SolverSpec& solver) {
  solver.correction_tolerance = std::max(solver.correction_tolerance, 0.1 * solver.accuracy);
}

void check_iterations(const Section& s, SolverSpec& solver) {
  if (solver.min_iterations > solver.max_iterations)
    s.fail("min_iterations", fmt::format("more than max_iterations; allowed: 0 to {}", solver.max_iterations));
}

}  // namespace

const Table<LoadingSpec>& loading_table() {
  using Row = Row<LoadingSpec>;
  static const Table<LoadingSpec> table{
      {Row::integer("steps", &LoadingSpec::steps, {1, 1000000},
                    "equal increments from load 0 to 1, besides outputs and turns of amplitudes"),
       Row::choice("control", &LoadingSpec::control, "what an increment is a part of"),
       Row::value("outputs", &LoadingSpec::outputs, "loads hit exactly and written as fields")
           .otherwise("every step")
           .written_if([](const LoadingSpec& loading) { return !loading.every_step; })},
      {},
      check_outputs};
  return table;
}

const Table<SolverSpec>& solver_table() {
  using Row = Row<SolverSpec>;
  constexpr Allowed kAccuracy{[](double x) { return x == 0.0 || (x >= 1e-6 && x <= 0.1); }, "0 (none), or 1e-6 to 0.1"};
  constexpr Allowed kIncrement{kNotNegative.holds, "a positive number, or 0 (any)"};
  constexpr Allowed kRadius{kNotNegative.holds, "a positive number, m, or 0 (by scale)"};
  static const Table<SolverSpec> table{
      {Row::number("accuracy", &SolverSpec::accuracy, kAccuracy,
                   "part of the external work that increments longer than 1/steps may miss; sets the tolerances "
                   "unless they are given"),
       Row::number("residual_tolerance", &SolverSpec::residual_tolerance, kFraction, "relative to the forces")
           .filled(residual_of_accuracy),
       Row::number("correction_tolerance", &SolverSpec::correction_tolerance, kFraction,
                   "relative to the displacement of the increment")
           .filled(correction_of_accuracy),
       Row::integer("min_iterations", &SolverSpec::min_iterations, {0, 1000},
                    "corrections made even if the residual is small already"),
       Row::integer("max_iterations", &SolverSpec::max_iterations, {1, 1000}, "before an increment is cut"),
       Row::number("min_step", &SolverSpec::min_step, kFraction, "smallest increment of the load"),
       Row::number("max_plastic_increment", &SolverSpec::max_plastic_increment, kIncrement,
                   "growth of a cell's plastic multiplier beyond which an increment is halved, down to 1/16 of "
                   "1/steps; 0: any"),
       Row::value("extrapolate", &SolverSpec::extrapolate, "start from the last increment continued"),
       Row::integer("gauss_points", &SolverSpec::gauss_points, {1, 4}, "contact points a crack segment, 1 to 4"),
       Row::number("search_radius", &SolverSpec::search_radius, kRadius, "m").otherwise("by scale")},
      {},
      check_iterations};
  return table;
}

}  // namespace cleft::scene
