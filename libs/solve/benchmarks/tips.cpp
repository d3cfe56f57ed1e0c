// The block of Liu and Borja 2010, section 6.1, with branch functions within range(1) elements of its tip, and with
// contact at small strain.
#include <benchmark/benchmark.h>

#include <type_traits>

#include "cleft/assembly/assembler.hpp"
#include "solve/tests/small_models.hpp"

namespace {

using namespace cleft;
using namespace cleft::solve;

assembly::Model enriched_block(std::int64_t across, std::int64_t elements) {
  auto m = models::block(static_cast<int>(across), contact::NegativeSide::Left);
  m.cracks[0].tip_radius = static_cast<double>(elements) * 0.04 / static_cast<double>(across);
  models::discretise(m, 1.0, 0.3, contact::NegativeSide::Left, 1e10);
  return m;
}

template <class Law>
void assemble(benchmark::State& state, bool undeformed) {
  auto model = enriched_block(state.range(0), state.range(1));
  model.surfaces.undeformed = undeformed;
  if constexpr (!std::is_same_v<Law, constitutive::FinitePlastic>)
    model.materials = {Law{model.constants(0)}};
  else
    model.materials = {Law{{model.constants(0), 1.5e9, 0.8, 0.7, 0.0}}};
  assembly::Assembler assembler(model);
  const auto rest = assembly::state_at_rest(model);
  for (auto _ : state) benchmark::DoNotOptimize(assembler.assemble(rest.displacement, rest.history));
  const auto& s = assembler.seconds();
  const auto runs = static_cast<double>(s.assemblies);
  state.counters["cells"] = static_cast<double>(model.cells.size());
  state.counters["tip_points"] = static_cast<double>(model.tip_points.size());
  state.counters["us_bulk"] = 1e6 * s.bulk / runs;
  state.counters["ns_per_contact_point"] = 1e9 * s.contact / runs / static_cast<double>(model.surfaces.points.size());
}
void assemble_hencky(benchmark::State& state) { assemble<constitutive::Hencky>(state, false); }
void assemble_small_strain(benchmark::State& state) { assemble<constitutive::LinearElastic>(state, true); }
void assemble_plastic(benchmark::State& state) { assemble<constitutive::FinitePlastic>(state, false); }
BENCHMARK(assemble_hencky)->ArgsProduct({{64}, {0, 4, 10}})->Unit(benchmark::kMicrosecond);
BENCHMARK(assemble_small_strain)->ArgsProduct({{64}, {0, 4, 10}})->Unit(benchmark::kMicrosecond);
BENCHMARK(assemble_plastic)->ArgsProduct({{64}, {0, 4}})->Unit(benchmark::kMicrosecond);

}  // namespace
