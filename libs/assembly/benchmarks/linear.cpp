// Pattern, factorisation and solution for the block at rest, by size of the mesh.
#include <benchmark/benchmark.h>

#include "../tests/small_models.hpp"
#include "cleft/assembly/assembler.hpp"
#include "cleft/assembly/linear_solver.hpp"
#include "cleft/assembly/state.hpp"

namespace {

using namespace cleft;

void block_pattern(benchmark::State& state) {
  const auto model = assembly::models::block(static_cast<int>(state.range(0)), contact::NegativeSide::Left);
  std::vector<std::array<Index, 2>> blocks;
  for (const auto& cell : model.cells)
    for (const Index i : cell.unknown)
      for (const Index j : cell.unknown) blocks.push_back({i, j});
  for (auto _ : state) {
    assembly::BlockMatrix matrix(model.unknowns.count, blocks);
    benchmark::DoNotOptimize(matrix);
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(blocks.size()));
}
BENCHMARK(block_pattern)->Arg(16)->Arg(64)->Unit(benchmark::kMicrosecond);

// Symmetric as it stands: stiffness at rest, with stuck faces. Held by a spring at every unknown.
void factorise_and_solve(benchmark::State& state, assembly::Factorisation kind) {
  const auto model = assembly::models::block(static_cast<int>(state.range(0)), contact::NegativeSide::Left);
  assembly::Assembler assembler(model);
  const auto rest = assembly::state_at_rest(model);
  if (assembler.assemble(rest.displacement, rest.history)) return state.SkipWithError("no state at rest");
  auto& matrix = assembler.matrix();
  const Mat2 hold = 1e-3 * model.stiffness() * Mat2::Identity();
  for (Index i = 0; i < matrix.size(); ++i) matrix.add(matrix.find(i, i), hold);
  const VecX b = VecX::Ones(matrix.rows());
  assembly::LinearSolver solver(kind);
  solver.new_pattern(1);
  for (auto _ : state) {
    if (solver.factorise(matrix) != assembly::Factors::Regular) return state.SkipWithError("singular");
    benchmark::DoNotOptimize(solver.solve(matrix, b));
  }
  state.counters["components"] = static_cast<double>(matrix.rows());
  state.counters["fallbacks"] = static_cast<double>(solver.seconds().unsymmetric_fallbacks);
}
BENCHMARK_CAPTURE(factorise_and_solve, unsymmetric, assembly::Factorisation::Unsymmetric)
    ->Arg(16)
    ->Arg(64)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(factorise_and_solve, symmetric, assembly::Factorisation::Symmetric)
    ->Arg(16)
    ->Arg(64)
    ->Unit(benchmark::kMillisecond);

}  // namespace
