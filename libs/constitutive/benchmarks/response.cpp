#include <benchmark/benchmark.h>

#include "cleft/constitutive/hencky.hpp"
#include "cleft/constitutive/linear_elastic.hpp"
#include "cleft/constitutive/neo_hookean.hpp"

namespace {

template <class Material>
void respond(benchmark::State& state) {
  const Material material{cleft::constitutive::lame(1e10, 0.25)};
  cleft::Mat2 F;
  F << 1.1, 0.2, -0.05, 0.9;
  for (auto _ : state) {
    benchmark::DoNotOptimize(F);
    auto response = material.respond(F);
    benchmark::DoNotOptimize(response);
  }
}
BENCHMARK(respond<cleft::constitutive::Hencky>);
BENCHMARK(respond<cleft::constitutive::NeoHookean>);
BENCHMARK(respond<cleft::constitutive::LinearElastic>);

}  // namespace
