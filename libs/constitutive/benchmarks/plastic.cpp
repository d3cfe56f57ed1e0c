#include "cleft/constitutive/plastic.hpp"

#include <benchmark/benchmark.h>

#include "cleft/constitutive/kinematics.hpp"
#include "cleft/constitutive/localisation.hpp"

namespace {

using namespace cleft::constitutive;

const DruckerPrager kMaterial{lame(1e10, 0.25), 1.5e9, 0.8, 0.7, 1e8};

cleft::Mat2 gradient_of(Branch branch) {
  cleft::Mat2 F;
  switch (branch) {
    case Branch::Elastic:
      F << 1.01, 0.02, -0.01, 0.99;
      break;
    case Branch::Smooth:
      F << 1.1, 0.5, -0.05, 0.9;
      break;
    case Branch::Apex:
      F << 1.4, 0.02, -0.01, 1.4;
      break;
  }
  return F;
}

template <class Law, Branch branch>
void respond_on(benchmark::State& state) {
  const Law law{kMaterial};
  const PlasticState committed{{0.01, -0.01, 0.005, 0.001}, 0.01};
  PlasticState updated;
  cleft::Mat2 F = argument_of<Law>(gradient_of(branch) - cleft::Mat2::Identity());
  for (auto _ : state) {
    benchmark::DoNotOptimize(F);
    auto response = law.respond(F, committed, updated);
    benchmark::DoNotOptimize(response);
    benchmark::DoNotOptimize(updated);
  }
}
BENCHMARK(respond_on<SmallPlastic, Branch::Elastic>);
BENCHMARK(respond_on<SmallPlastic, Branch::Smooth>);
BENCHMARK(respond_on<SmallPlastic, Branch::Apex>);
BENCHMARK(respond_on<FinitePlastic, Branch::Elastic>);
BENCHMARK(respond_on<FinitePlastic, Branch::Smooth>);
BENCHMARK(respond_on<FinitePlastic, Branch::Apex>);

void localisation_of_flow(benchmark::State& state) {
  const FinitePlastic law{kMaterial};
  cleft::Mat2 F = gradient_of(Branch::Smooth);
  PlasticState flown;
  law.respond(F, {}, flown);
  for (auto _ : state) {
    benchmark::DoNotOptimize(F);
    auto found = localisation(law, F, flown);
    benchmark::DoNotOptimize(found);
  }
}
BENCHMARK(localisation_of_flow);

}  // namespace
