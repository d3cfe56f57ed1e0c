// Search and pair forces of a crack through a square, after a slip of a third of its length.
#include <benchmark/benchmark.h>

#include "contact/tests/slider.hpp"

namespace {

using namespace cleft;

void search(benchmark::State& state, contact::NegativeSide side) {
  contact::Slider slider(side, static_cast<int>(state.range(0)));
  const VecX u = slider.shift({0.33, -1e-3});
  for (auto _ : state) {
    slider.look(u);
    benchmark::DoNotOptimize(slider.pairs.data());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(slider.pairs.size()));
}
BENCHMARK_CAPTURE(search, one_side, contact::NegativeSide::Right)->Arg(20)->Arg(200)->Arg(2000);
BENCHMARK_CAPTURE(search, both_sides, contact::NegativeSide::Both)->Arg(20)->Arg(200)->Arg(2000);

void pair_force(benchmark::State& state) {
  contact::Slider slider(contact::NegativeSide::Right);
  slider.look(slider.shift({0.33, -1e-3}));
  const Index p = 1;
  const auto points =
      contact::pair_points(slider.surfaces, slider.search.positions(), p, slider.pairs[p], slider.past[p]);
  const auto constants =
      contact::pair_constants(slider.surfaces, slider.search.positions(), p, slider.pairs[p], slider.past[p]);
  for (auto _ : state) {
    const auto s = contact::evaluate(points, constants);
    benchmark::DoNotOptimize(contact::force(points, constants, s));
  }
}
BENCHMARK(pair_force);

}  // namespace
