// Time to cut a mesh by a straight crack and by a long wavy one; items are the triangles of the mesh.
#include "cleft/geometry/cut.hpp"

#include <benchmark/benchmark.h>

namespace {

using namespace cleft::geometry;

Mesh mesh_of(std::int64_t triangles) {
  int cells = 1;
  while (2 * std::int64_t{cells} * cells < triangles) ++cells;
  return structured_mesh({0, 0, 1, 1}, {cells, cells}, Diagonal::Alternating);
}

void run(benchmark::State& state, const Crack& crack) {
  const Mesh mesh = mesh_of(state.range(0));
  std::size_t elements = 0;
  for (auto _ : state) {
    const CutMesh result = cut(mesh, {crack});
    elements = result.elements.size();
    benchmark::DoNotOptimize(elements);
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(mesh.triangles.size()));
  state.counters["cut"] = static_cast<double>(elements);
}

void cut_straight(benchmark::State& state) { run(state, {"c", {{0, 0.21}, {0.93, 0.71}}}); }
void cut_wavy(benchmark::State& state) { run(state, {"c", sine_curve({0, 0.503}, {1, 0.503}, 0.21, 3.0, 1e-5)}); }
void every_edge(benchmark::State& state) {
  const Mesh mesh = mesh_of(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(edges_of(mesh));
}

BENCHMARK(cut_straight)->Arg(10'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond);
BENCHMARK(cut_wavy)->Arg(10'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond);
BENCHMARK(every_edge)->Arg(10'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

}  // namespace
