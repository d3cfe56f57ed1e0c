// Beyond the limit load of the yielding block: on meshes from 32 x 64 cells on, flow localises so fast that the load
// must fall before it can rise.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "cleft/simulation/failure_words.hpp"
#include "comparison.hpp"
#include "solved.hpp"

namespace cleft::verification {
namespace {

const std::string kMesh = "mesh.cells=[32,64]";
// No bound on what flows in an increment: both then take increments of the same length.
const std::string kAnyFlow = "solver.max_plastic_increment=0";

TEST(LimitLoad, StopsARunThatOnlyRaisesTheLoad) {
  const auto scene = scene_of("block_yield_finite", {kMesh});
  const auto model = problem::build_model(scene);
  solve::LoadStepper stepper(model, problem::step_controls(scene));
  for (;;) {
    const auto outcome = stepper.advance();
    ASSERT_FALSE(stepper.done());
    const auto* failure = std::get_if<assembly::Failure>(&outcome);
    if (!failure) continue;
    EXPECT_EQ(failure->kind, assembly::FailureKind::NoConvergence);
    const std::string advice = simulation::advice(*failure, model);
    EXPECT_NE(advice.find("loading.control = \"path\""), std::string::npos);
    EXPECT_NE(advice.find("material.viscosity"), std::string::npos);
    break;
  }
  Case table("yielding block, finite strain, 32 across, load control");
  table.compare("load that it reaches", stepper.state().load, prototype(0.54), within(0.01, "the increments' size"));
}

TEST(LimitLoad, IsPassedAlongThePathAndWithViscosityToTheSameEnd) {
  const Solved path = solve("block_yield_finite", {kMesh, kAnyFlow, "loading.control=\"path\""});
  const auto load = path.history.column("load");
  const auto top = std::adjacent_find(load.begin(), load.end(), std::greater<>());
  ASSERT_NE(top, load.end()) << "the load never falls";
  EXPECT_LT(*std::min_element(top, load.end()), *top - 0.01);
  EXPECT_LE(path.result.cuts, 2);
  EXPECT_LE(path.result.iterations, 4 * path.result.increments);
  const Solved viscous = solve("block_yield_finite", {kMesh, kAnyFlow, "material.viscosity=1e7"});
  EXPECT_LE(viscous.result.cuts, 2);
  EXPECT_GT(viscous.result.energies.viscous_dissipation, 0.0);

  Case table("yielding block, finite strain, 32 across, beyond the limit load");
  table.compare("limit load", *top, prototype(0.54), within(0.01, "the increments' size"));
  const auto& energies = path.result.energies;
  table.compare("energy unaccounted for, over work", energies.imbalance() / energies.external_work, exact(0),
                within(0.005, "trapezoidal sums while the forces fall by half"));
  const double fy = path.at("fy_top", 1.0);
  EXPECT_NEAR(fy, viscous.at("fy_top", 1.0), 0.01 * std::abs(fy)) << "the viscous stress is small";
}

}  // namespace
}  // namespace cleft::verification
