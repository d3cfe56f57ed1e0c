// Numbering, cells and faces of a square with a crack through it; the time does not contain the cut.
#include <benchmark/benchmark.h>

#include "cleft/enrichment/stencil.hpp"

namespace {

using namespace cleft;

void discretise(benchmark::State& state) {
  const auto cells = static_cast<int>(state.range(0));
  const auto mesh = geometry::structured_mesh({0, 0, 1, 1}, {cells, cells}, geometry::Diagonal::Right);
  const auto cut = geometry::cut(mesh, {{"crack", {{0.0, 0.43}, {1.0, 0.58}}}});
  for (auto _ : state) {
    const auto unknowns = enrichment::number_unknowns(mesh, cut);
    benchmark::DoNotOptimize(enrichment::make_cells(mesh, cut, unknowns));
    benchmark::DoNotOptimize(enrichment::make_faces(mesh, cut, unknowns));
  }
  state.counters["triangles"] = static_cast<double>(mesh.triangles.size());
}
BENCHMARK(discretise)->Arg(16)->Arg(128)->Unit(benchmark::kMicrosecond);

}  // namespace
