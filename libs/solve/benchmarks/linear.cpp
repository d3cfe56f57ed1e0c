// Pattern, factorisation and solution for the block at rest, by size of the mesh.
#include <benchmark/benchmark.h>

#include <cstdlib>

#include "cleft/assembly/assembler.hpp"
#include "cleft/assembly/state.hpp"
#include "mumps.hpp"
#include "solve/tests/small_models.hpp"
#include "umfpack.hpp"

namespace {

using namespace cleft;
using namespace cleft::solve;

void block_pattern(benchmark::State& state) {
  const auto model = models::block(static_cast<int>(state.range(0)), contact::NegativeSide::Left);
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

// The matrix at rest, with stuck faces: symmetric as it stands, held by a spring at every unknown. Numeric
// factorisation and solution; the analysis is made once before.
struct Held {
  assembly::Model model;
  assembly::Assembler assembler;

  explicit Held(std::int64_t across)
      : model(models::block(static_cast<int>(across), contact::NegativeSide::Left)), assembler(model) {
    const auto rest = assembly::state_at_rest(model);
    if (assembler.assemble(rest.displacement, rest.history)) std::abort();
    const Mat2 hold = 1e-3 * model.stiffness() * Mat2::Identity();
    for (Index i = 0; i < matrix().size(); ++i) matrix().add(matrix().find(i, i), hold);
  }
  assembly::BlockMatrix& matrix() { return assembler.matrix(); }
};

template <class Solver, class... Options>
void factorise_and_solve(benchmark::State& state, Options... options) {
  Held body(state.range(0));
  const VecX b = VecX::Ones(body.matrix().rows());
  SolverSeconds seconds;
  Solver solver(seconds, options...);
  const auto once = [&] {
    if (solver.factorise(body.matrix()) != Factors::Regular) state.SkipWithError("singular");
    benchmark::DoNotOptimize(solver.solve(b));
  };
  once();
  for (auto _ : state) once();
  state.counters["components"] = static_cast<double>(b.size());
  state.counters["analysis_ms"] = 1e3 * seconds.analyse;
}

void umfpack(benchmark::State& state) { factorise_and_solve<Umfpack>(state); }
void mumps_minimum_degree(benchmark::State& state) {
  factorise_and_solve<Mumps>(state, Factorisation::Unsymmetric, Index{1} << 30);
}
void mumps_nested_dissection(benchmark::State& state) {
  factorise_and_solve<Mumps>(state, Factorisation::Unsymmetric, Index{0});
}
void mumps_symmetric(benchmark::State& state) { factorise_and_solve<Mumps>(state, Factorisation::Symmetric); }

void sizes(benchmark::internal::Benchmark* all) {
  all->Arg(16)->Arg(32)->Arg(64)->Arg(128)->Arg(256)->Unit(benchmark::kMillisecond);
}
BENCHMARK(umfpack)->Apply(sizes);
BENCHMARK(mumps_minimum_degree)->Apply(sizes);
BENCHMARK(mumps_nested_dissection)->Apply(sizes);
BENCHMARK(mumps_symmetric)->Apply(sizes);

}  // namespace
