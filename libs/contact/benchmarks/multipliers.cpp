// Mortar contact on the two blocks of search.cpp: pieces, their integrals and the conditions of the hats, and the
// integrals of one piece.
#include "cleft/contact/multipliers.hpp"

#include <benchmark/benchmark.h>

#include "../tests/slider.hpp"

namespace {

using namespace cleft;

contact::Slider with_hats(contact::NegativeSide side, int cells) {
  contact::Slider slider(side, cells);
  slider.give_hats(1.0 / cells);
  return slider;
}

// Iterates on the way from a slip to one a fifth of a cell farther. Items are contact points, as in search.cpp.
void multipliers(benchmark::State& state, contact::NegativeSide side) {
  const auto cells = static_cast<int>(state.range(0));
  auto slider = with_hats(side, cells);
  const auto& surfaces = slider.surfaces;
  VecX u = slider.shift({0.33 + 0.17 / cells, -1e-3});
  u.tail(2 * static_cast<Index>(surfaces.hats.nodes.size())).setConstant(-1e-3);
  contact::Multipliers multipliers;
  slider.look(u);
  const auto rest = contact::hats_at_rest(surfaces);
  multipliers.run(surfaces, slider.search.positions(), slider.pairs, u, rest);
  const auto memory = multipliers.advance(surfaces, slider.search.positions(), rest).memory;
  const auto displacements = 2 * slider.unknowns.displacements();
  u.head(displacements) = slider.shift({0.33 + 0.37 / cells, -1e-3}).head(displacements);
  slider.look(u);
  for (auto _ : state) {
    multipliers.run(surfaces, slider.search.positions(), slider.pairs, u, memory);
    benchmark::DoNotOptimize(multipliers.conditions().data());
  }
  const auto points = static_cast<double>(slider.pairs.size());
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(points));
  state.counters["pieces_per_point"] = static_cast<double>(multipliers.pieces().size()) / points;
}
BENCHMARK_CAPTURE(multipliers, one_side, contact::NegativeSide::Right)->Arg(20)->Arg(200);
BENCHMARK_CAPTURE(multipliers, both_sides, contact::NegativeSide::Both)->Arg(20)->Arg(200);

void piece(benchmark::State& state, contact::NegativeSide side) {
  auto slider = with_hats(side, 20);
  slider.look(slider.shift({0.33, -1e-3}));
  const auto& at = slider.search.positions();
  const auto trails = contact::trails_at_rest(slider.surfaces);
  const auto pieces = contact::find_pieces(slider.surfaces, at, slider.pairs, trails);
  const std::array<Vec2, 2> tractions{Vec2(-1, 0.3), Vec2(-2, 0.5)};
  contact::OverlapIntegrals out;
  contact::SlipByAnchor by_anchor;
  for (auto _ : state) {
    contact::integrate(slider.surfaces, at, trails, std::span(pieces).subspan(pieces.size() / 3, 1), tractions, out,
                       std::span(&by_anchor, 1));
    benchmark::DoNotOptimize(&out);
    benchmark::ClobberMemory();
  }
}
BENCHMARK_CAPTURE(piece, one_side, contact::NegativeSide::Right);
BENCHMARK_CAPTURE(piece, both_sides, contact::NegativeSide::Both);

}  // namespace
