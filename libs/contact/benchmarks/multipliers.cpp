// Mortar contact on the two blocks of search.cpp: mortar segments, their integrals and the conditions of the hat
// functions, and the integrals of one mortar segment.
#include "cleft/contact/multipliers.hpp"

#include <benchmark/benchmark.h>

#include "contact/tests/slider.hpp"

namespace {

using namespace cleft;

contact::Slider with_multiplier_space(contact::NegativeSide side, int cells) {
  contact::Slider slider(side, cells);
  slider.add_multiplier_space(1.0 / cells);
  return slider;
}

// Iterates on the way from a slip to one a fifth of a cell farther. Items are contact points, as in search.cpp.
void multipliers(benchmark::State& state, contact::NegativeSide side) {
  const auto cells = static_cast<int>(state.range(0));
  auto slider = with_multiplier_space(side, cells);
  const auto& surfaces = slider.surfaces;
  VecX u = slider.shift({0.33 + 0.17 / cells, -1e-3});
  u.tail(2 * static_cast<Index>(surfaces.multiplier_space.nodes.size())).setConstant(-1e-3);
  contact::Multipliers multipliers;
  slider.look(u);
  const auto rest = contact::multipliers_at_rest(surfaces);
  multipliers.run(surfaces, slider.search.positions(), slider.pairs, u, rest);
  const auto past = multipliers.commit(surfaces, slider.search.positions(), rest).end;
  const auto displacements = 2 * slider.unknowns.displacements();
  u.head(displacements) = slider.shift({0.33 + 0.37 / cells, -1e-3}).head(displacements);
  slider.look(u);
  for (auto _ : state) {
    multipliers.run(surfaces, slider.search.positions(), slider.pairs, u, past);
    benchmark::DoNotOptimize(multipliers.conditions().data());
  }
  const auto points = static_cast<double>(slider.pairs.size());
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(points));
  state.counters["pieces_per_point"] = static_cast<double>(multipliers.mortar_segments().size()) / points;
}
BENCHMARK_CAPTURE(multipliers, one_side, contact::NegativeSide::Right)->Arg(20)->Arg(200);
BENCHMARK_CAPTURE(multipliers, both_sides, contact::NegativeSide::Both)->Arg(20)->Arg(200);

void mortar_segment(benchmark::State& state, contact::NegativeSide side) {
  auto slider = with_multiplier_space(side, 20);
  slider.look(slider.shift({0.33, -1e-3}));
  const auto& at = slider.search.positions();
  const auto anchor_maps = contact::anchor_maps_at_rest(slider.surfaces);
  const auto mortar_segments = contact::find_mortar_segments(slider.surfaces, at, slider.pairs, anchor_maps);
  const std::array<Vec2, 2> tractions{Vec2(-1, 0.3), Vec2(-2, 0.5)};
  contact::MortarIntegrals out;
  contact::SlipByAnchor by_anchor;
  for (auto _ : state) {
    contact::integrate(slider.surfaces, at, anchor_maps,
                       std::span(mortar_segments).subspan(mortar_segments.size() / 3, 1), tractions, out,
                       std::span(&by_anchor, 1));
    benchmark::DoNotOptimize(&out);
    benchmark::ClobberMemory();
  }
}
BENCHMARK_CAPTURE(mortar_segment, one_side, contact::NegativeSide::Right);
BENCHMARK_CAPTURE(mortar_segment, both_sides, contact::NegativeSide::Both);

}  // namespace
