// Contact at small strain: gaps and tractions of all points, and the force of one, on blocks that slide far.
#include "cleft/contact/undeformed.hpp"

#include <benchmark/benchmark.h>

#include "contact/tests/slider.hpp"

namespace {

using namespace cleft;

contact::Slider undeformed(int cells) {
  contact::Slider slider(contact::NegativeSide::Right, cells);
  slider.surfaces.undeformed = true;
  return slider;
}

void opposite(benchmark::State& state) {
  auto slider = undeformed(static_cast<int>(state.range(0)));
  const VecX u = slider.shift({0.33, -1e-3});
  for (auto _ : state) {
    slider.look(u);
    benchmark::DoNotOptimize(slider.pairs.data());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(slider.pairs.size()));
}
BENCHMARK(opposite)->Arg(20)->Arg(200)->Arg(2000);

void force_undeformed(benchmark::State& state) {
  auto slider = undeformed(20);
  slider.look(slider.shift({0.33, -1e-3}));
  constexpr Index kPoint = 1;
  for (auto _ : state)
    benchmark::DoNotOptimize(
        contact::force_undeformed(slider.surfaces, kPoint, slider.pairs[kPoint], slider.past[kPoint]));
}
BENCHMARK(force_undeformed);

}  // namespace
