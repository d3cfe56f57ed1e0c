// The block of Liu and Borja 2010, section 6.1: assembly of bulk and contact, pattern, factorisation and solution.
#include <benchmark/benchmark.h>

#include "cleft/solve/stepping.hpp"
#include "solve/tests/small_models.hpp"

namespace {

using namespace cleft;
using namespace cleft::solve;

void assemble(benchmark::State& state) {
  const auto model = models::block(static_cast<int>(state.range(0)), contact::NegativeSide::Left);
  assembly::Assembler assembler(model);
  const auto rest = assembly::state_at_rest(model);
  for (auto _ : state) benchmark::DoNotOptimize(assembler.assemble(rest.displacement, rest.history));
  const auto& s = assembler.seconds();
  const auto runs = static_cast<double>(state.iterations());
  state.counters["ns_per_cell"] = 1e9 * s.bulk / runs / static_cast<double>(model.cells.size());
  state.counters["ns_per_contact_point"] = 1e9 * s.contact / runs / static_cast<double>(model.surfaces.points.size());
}
BENCHMARK(assemble)->Arg(16)->Arg(64);

// In the last iteration of an increment in which the faces slide, by springs or by multipliers.
void assemble_contact(benchmark::State& state, contact::NegativeSide side, models::Contact contact) {
  const auto model = models::block(static_cast<int>(state.range(0)), side, geometry::Diagonal::Right, contact);
  LoadStepper stepper(model, {});
  for (int k = 0; k < 4; ++k)
    if (std::holds_alternative<assembly::Failure>(stepper.advance())) return state.SkipWithError("an increment failed");
  const auto history = stepper.state().history;
  if (std::holds_alternative<assembly::Failure>(stepper.advance())) return state.SkipWithError("an increment failed");
  assembly::Assembler assembler(model);
  for (auto _ : state) benchmark::DoNotOptimize(assembler.assemble(stepper.state().displacement, history));
  state.counters["ns_per_contact_point"] = 1e9 * assembler.seconds().contact / static_cast<double>(state.iterations()) /
                                           static_cast<double>(model.surfaces.points.size());
}
BENCHMARK_CAPTURE(assemble_contact, springs_one_side, contact::NegativeSide::Left, models::Contact::Springs)->Arg(32);
BENCHMARK_CAPTURE(assemble_contact, springs_both_sides, contact::NegativeSide::Both, models::Contact::Springs)->Arg(32);
BENCHMARK_CAPTURE(assemble_contact, mortar_one_side, contact::NegativeSide::Left, models::Contact::Multipliers)
    ->Arg(32);
BENCHMARK_CAPTURE(assemble_contact, mortar_both_sides, contact::NegativeSide::Both, models::Contact::Multipliers)
    ->Arg(32);

void pattern(benchmark::State& state) {
  const auto model = models::block(static_cast<int>(state.range(0)), contact::NegativeSide::Left);
  for (auto _ : state) {
    assembly::Assembler assembler(model);
    benchmark::DoNotOptimize(assembler);
  }
}
BENCHMARK(pattern)->Arg(16)->Arg(64);

void first_increment(benchmark::State& state) {
  const auto model = models::block(static_cast<int>(state.range(0)), contact::NegativeSide::Left);
  for (auto _ : state) {
    LoadStepper stepper(model, {});
    benchmark::DoNotOptimize(stepper.advance());
  }
}
BENCHMARK(first_increment)->Arg(16)->Arg(64)->Unit(benchmark::kMillisecond);

}  // namespace
