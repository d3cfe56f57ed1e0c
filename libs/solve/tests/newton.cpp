// The iteration and the stepping on the sliding block.
#include "cleft/solve/newton.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "cleft/geometry/delaunay.hpp"
#include "cleft/solve/stepping.hpp"
#include "small_models.hpp"

namespace cleft::solve {
namespace {

using contact::NegativeSide;

void advance_to(LoadStepper& stepper, double load, std::size_t* iterations = nullptr) {
  while (stepper.state().load < load - 1e-9) {
    const auto outcome = stepper.advance();
    ASSERT_TRUE(std::holds_alternative<Step>(outcome)) << name_of(std::get<assembly::Failure>(outcome).kind);
    if (iterations) *iterations += std::get<Step>(outcome).iterations.size();
  }
}

TEST(Newton, ConvergesQuadraticallyWhileThePartnersStay) {
  const assembly::Model model = models::block(8, NegativeSide::Left);
  LoadStepper stepper(model, {});
  advance_to(stepper, 0.3);
  int seen = 0;
  while (stepper.state().load < 0.5) {
    const auto step = std::get<Step>(stepper.advance());
    const auto& its = step.iterations;
    for (std::size_t k = 1; k < its.size(); ++k) {
      const double before = its[k - 1].residual, after = its[k].residual;
      const bool same = its[k].partner_changes + its[k].status_changes == 0;
      if (!same || before > 1e-2 || before < 1e-5 || after < 10 * its[k].rounding) continue;
      ++seen;
      EXPECT_LT(std::log(after), 1.6 * std::log(before)) << "at load " << step.load;
    }
  }
  EXPECT_GE(seen, 3);
}

TEST(Newton, MakesTheCorrectionsThatAreAskedForAtLeast) {
  const assembly::Model model = models::block(8, NegativeSide::Left);
  StepControls controls;
  controls.newton.min_iterations = 5;
  LoadStepper stepper(model, controls);
  for (int k = 0; k < 4; ++k) {
    const auto step = std::get<Step>(stepper.advance());
    EXPECT_GE(step.iterations.size(), 5u);
    EXPECT_EQ(step.left.correction, 0.0);
    EXPECT_LT(step.left.residual, step.left.rounding);
  }
}

TEST(Newton, TellsWhereTheResidualIsLargest) {
  using At = LargestResidual::At;
  const assembly::Model model = models::block(8, NegativeSide::Left);
  LoadStepper stepper(model, {});
  const auto [low, high] = geometry::box_around(model.mesh);
  int at_contact = 0, at_node = 0;
  while (stepper.state().load < 0.3) {
    const auto step = std::get<Step>(stepper.advance());
    for (const Iteration& it : step.iterations) {
      if (it.residual == 0.0) continue;
      ASSERT_TRUE(it.largest.at == At::Contact || it.largest.at == At::Node);
      ++(it.largest.at == At::Contact ? at_contact : at_node);
      const Vec2 place = it.largest.place - model.origin;
      EXPECT_TRUE((place.array() >= low.array()).all() && (place.array() <= high.array()).all()) << place.transpose();
    }
  }
  EXPECT_GT(at_contact, 0);
  EXPECT_GT(at_contact + at_node, 10);
}

TEST(LoadStepper, KeepsTheIterationsOfAttemptsThatFailed) {
  const assembly::Model model = models::block(8, NegativeSide::Left);
  StepControls controls;
  controls.steps = 2;
  controls.newton.max_iterations = 3;
  LoadStepper stepper(model, controls);
  const auto first = std::get<Step>(stepper.advance());
  ASSERT_GT(first.cuts, 0);
  const auto failed = stepper.failed_attempts();
  ASSERT_GE(failed.size(), static_cast<std::size_t>(first.cuts));
  EXPECT_EQ(failed.front().load, 0.5);
  EXPECT_LT(failed.back().load, 0.5);
  for (const FailedAttempt& attempt : failed)
    for (std::size_t k = 0; k + 1 < attempt.iterations.size(); ++k) EXPECT_GT(attempt.iterations[k].correction, 0.0);
  while (stepper.failed_attempts().size() > 0 && !stepper.done())
    ASSERT_TRUE(std::holds_alternative<Step>(stepper.advance())) << "they are those of the last increment only";
  EXPECT_FALSE(stepper.done());
}

TEST(Newton, ExtrapolationSavesIterationsAndChangesNothingElse) {
  std::array<std::size_t, 2> iterations{};
  std::array<Vec2, 2> force;
  for (const bool extrapolate : {false, true}) {
    const assembly::Model model = models::block(8, NegativeSide::Left);
    StepControls controls;
    controls.newton.extrapolate = extrapolate;
    LoadStepper stepper(model, controls);
    ASSERT_NO_FATAL_FAILURE(advance_to(stepper, 0.4, &iterations[extrapolate]));
    force[extrapolate] = stepper.reactions()[1];
  }
  EXPECT_LT(iterations[1], iterations[0]);
  EXPECT_LT((force[1] - force[0]).norm(), 1e-5 * force[0].norm());
}

TEST(Newton, KeepsFactorsForTheLastCorrectionOnly) {
  std::array<int, 2> kept{};
  std::array<Vec2, 2> force;
  for (const bool whole : {false, true}) {
    const assembly::Model model = models::block(8, NegativeSide::Left);
    StepControls controls;
    if (whole) controls.newton.residual_tolerance = 1e-12;
    LoadStepper stepper(model, controls);
    while (stepper.state().load < 0.4) {
      const auto outcome = stepper.advance();
      ASSERT_TRUE(std::holds_alternative<Step>(outcome)) << name_of(std::get<assembly::Failure>(outcome).kind);
      const auto& step = std::get<Step>(outcome);
      EXPECT_LE(step.left.residual, std::max(controls.newton.residual_tolerance, step.left.rounding));
      for (std::size_t i = 0; i < step.iterations.size(); ++i) {
        kept[whole] += step.iterations[i].kept;
        EXPECT_TRUE(!step.iterations[i].kept || i + 1 == step.iterations.size()) << "step " << step.number;
      }
    }
    force[whole] = stepper.reactions()[1];
  }
  EXPECT_GE(kept[0], 10);
  EXPECT_LT(kept[1], kept[0]);
  EXPECT_LT((force[1] - force[0]).norm(), 1e-7 * force[0].norm());
}

TEST(Newton, TightToleranceNeedsNoMoreThanRounding) {
  const assembly::Model model = models::block(8, NegativeSide::Right);
  StepControls controls;
  controls.newton.residual_tolerance = 0.0;  // out of reach: only the rounding floor ends the iteration
  LoadStepper stepper(model, controls);
  for (int k = 0; k < 5; ++k) {
    const auto outcome = stepper.advance();
    ASSERT_TRUE(std::holds_alternative<Step>(outcome)) << name_of(std::get<assembly::Failure>(outcome).kind);
    const auto& step = std::get<Step>(outcome);
    EXPECT_EQ(step.cuts, 0);
    EXPECT_LE(step.left.residual, step.left.rounding);
  }
}

// Whole corrections lead a point of the kinked crack from open to stick to slip and back to open, at any load.
TEST(Newton, LeavesTheCirclesOfChatteringContact) {
  const std::vector<Vec2> points = {{0.014759754656912785, 0.045191111662018252},
                                    {0.034727672492621729, 0.064835823018930344},
                                    {0.056178867885781948, 0.058087144421048981}};
  constexpr double kSize = 0.008638954473339266;
  assembly::Model m;
  m.mesh = geometry::delaunay_mesh(geometry::box_outline({0, 0, 0.04, 0.08}),
                                   {kSize, 0.25, {{points, kSize}, {{points.front()}, kSize}}});
  m.cracks = {{"main", points}};
  models::discretise(m, 1.0, 0.277, NegativeSide::Left, 1e10);
  m.prescribed = {models::hold(m, "bottom", {0, 0}), models::hold(m, "top", {7.07e-5, -2.4066e-3})};
  StepControls controls;
  controls.steps = 4;
  LoadStepper stepper(m, controls);
  while (!stepper.done()) {
    const auto outcome = stepper.advance();
    ASSERT_TRUE(std::holds_alternative<Step>(outcome)) << name_of(std::get<assembly::Failure>(outcome).kind);
    EXPECT_EQ(std::get<Step>(outcome).cuts, 0);
  }
}

TEST(Newton, FailsWithTheResidualWhenIterationsRunOut) {
  const assembly::Model model = models::block(8, NegativeSide::Left);
  NewtonControls controls;
  controls.max_iterations = 1;
  assembly::Assembler assembler(model);
  LinearSolver solver(Factorisation::Unsymmetric);
  const auto increment =
      solve_increment({model, constraints_of(model), state_at_rest(model), controls, assembler, solver}, {0.1});
  ASSERT_TRUE(increment.failure);
  EXPECT_EQ(increment.failure->kind, assembly::FailureKind::NoConvergence);
  const auto& unbalanced = std::get<assembly::Unbalanced>(increment.failure->finding);
  EXPECT_EQ(unbalanced.iterations, 1);
  EXPECT_GT(unbalanced.residual, controls.residual_tolerance);
  EXPECT_EQ(unbalanced.largest.reference, model.mesh.nodes.at(static_cast<std::size_t>(unbalanced.largest.node)));
  EXPECT_EQ(increment.iterations.size(), 1u);
}

// A radius below the penetration hides the partner: nothing would hold the faces apart.
TEST(Newton, SaysWhereTheSearchLosesFacesInContact) {
  assembly::Model model = models::block(8, NegativeSide::Left);
  model.surfaces.search_radius = 1e-6;
  StepControls controls;
  controls.steps = 8;
  LoadStepper stepper(model, controls);
  for (;;) {
    const auto outcome = stepper.advance();
    ASSERT_FALSE(stepper.done()) << "the faces have passed through each other";
    const auto* failure = std::get_if<assembly::Failure>(&outcome);
    if (!failure) continue;
    EXPECT_EQ(failure->kind, assembly::FailureKind::Tunnelling) << name_of(failure->kind);
    const auto& passed = std::get<assembly::PassedPoint>(failure->finding);
    EXPECT_EQ(passed.crack, 0);
    EXPECT_GT(passed.depth, model.surfaces.search_radius);
    break;
  }
}

// Springs may be so stiff that every state is an equilibrium but for their rounding: that is none.
TEST(Newton, FailsWhereTheRoundingOfTheSpringsHidesTheForces) {
  for (const auto& [scale, converges] : {std::pair{1.0, true}, {100.0, true}, {1e16, false}}) {
    assembly::Model model = models::block(8, NegativeSide::Left);
    for (auto& springs : model.surfaces.springs) {
      springs.normal *= scale;
      springs.tangential *= scale;
    }
    assembly::Assembler assembler(model);
    LinearSolver solver(Factorisation::Unsymmetric);
    const auto increment =
        solve_increment({model, constraints_of(model), state_at_rest(model), {}, assembler, solver}, {1e-5});
    EXPECT_EQ(!increment.failure, converges) << scale;
    if (!converges && increment.failure) {
      EXPECT_TRUE(std::holds_alternative<assembly::RoundingOfSprings>(increment.failure->finding));
    }
  }
}

TEST(Newton, AnIncrementOfNothingFromAConvergedStateNeedsNoIteration) {
  const assembly::Model model = models::block(8, NegativeSide::Left);
  LoadStepper stepper(model, {});
  ASSERT_NO_FATAL_FAILURE(advance_to(stepper, 0.2));
  assembly::Assembler assembler(model);
  LinearSolver solver(Factorisation::Unsymmetric);
  NewtonControls controls;
  controls.correction_tolerance = 1e300;  // judged by the residual alone
  controls.extrapolate = false;
  const assembly::State& state = stepper.state();
  const auto increment =
      solve_increment({model, constraints_of(model), state, controls, assembler, solver}, {state.load});
  ASSERT_FALSE(increment.failure) << name_of(increment.failure->kind);
  EXPECT_LE(increment.iterations.size(), 1u) << "the moved anchors reproduce the tractions";
  EXPECT_LT((increment.displacement - state.displacement).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(LoadStepper, RetriesHoweverShortThePlannedIncrementsAre) {
  const assembly::Model model = models::block(8, NegativeSide::Left);
  StepControls controls;
  controls.steps = 5;
  controls.min_step = 0.5;  // longer than an increment
  controls.newton.max_iterations = 4;
  LoadStepper stepper(model, controls);
  const auto outcome = stepper.advance();
  ASSERT_TRUE(std::holds_alternative<Step>(outcome)) << name_of(std::get<assembly::Failure>(outcome).kind);
  EXPECT_GT(std::get<Step>(outcome).cuts, 0);
}

TEST(LoadStepper, WhichSideIsIntegratedHardlyMatters) {
  std::array<Vec2, 3> force;
  for (const auto side : {NegativeSide::Right, NegativeSide::Left, NegativeSide::Both}) {
    const assembly::Model model = models::block(8, side);
    LoadStepper stepper(model, {});
    ASSERT_NO_FATAL_FAILURE(advance_to(stepper, 0.5));
    force[static_cast<int>(side)] = stepper.reactions()[1];
  }
  for (const Vec2& other : force) EXPECT_NEAR(other.y() / force[0].y(), 1.0, 0.005);
}

TEST(LoadStepper, BalancesTheEnergyOfTheSlidingBlockUpToTheSizeOfTheIncrements) {
  for (const auto& [steps, rest] : {std::pair{25, 5e-4}, {100, 1e-4}, {400, 2e-5}}) {
    const assembly::Model model = models::block(8, NegativeSide::Right);
    StepControls controls;
    controls.steps = steps;
    LoadStepper stepper(model, controls);
    ASSERT_NO_FATAL_FAILURE(advance_to(stepper, 0.8));
    const assembly::Energies& e = stepper.state().energies;
    EXPECT_GT(e.friction_dissipation, 0.05 * e.external_work);
    EXPECT_LT(std::fabs(e.imbalance()), rest * e.external_work) << steps << " steps";
  }
}

TEST(LoadStepper, RemembersTheDeepestPenetrationOfAllIncrements) {
  assembly::Model model = models::block(8, NegativeSide::Left);
  model.prescribed[1].displacement = [](const Vec2&, geometry::MaybeSide, double load) {  // there and halfway back
    return Vec2(Vec2(-0.01, -0.01) * std::fmin(load, 0.6 - load));
  };
  LoadStepper stepper(model, {});
  double deepest = 0.0, now = 0.0;
  while (stepper.state().load < 0.45 - 1e-9) {
    ASSERT_TRUE(std::holds_alternative<Step>(stepper.advance()));
    now = 0.0;
    for (const auto& pair : stepper.pairs()) now = std::max(now, -pair.state.normal_gap);
    deepest = std::max(deepest, now);
    EXPECT_EQ(stepper.state().history.deepest, deepest);
  }
  EXPECT_LT(now, deepest);
}

TEST(LoadStepper, ARestoredRunGoesOnBitForBit) {
  const assembly::Model model = models::block(8, NegativeSide::Left);
  LoadStepper stepper(model, {});
  long patterns = 0;
  while (stepper.state().load < 0.9) {
    ASSERT_NO_FATAL_FAILURE(advance_to(stepper, stepper.state().load + 0.02));
    LoadStepper resumed(model, {});
    resumed.restore(stepper.state(), stepper.place(), stepper.assembler().reserved_couplings());
    const long pattern = stepper.assembler().pattern_version();
    for (int k = 0; k < 2; ++k) {
      const auto one = stepper.advance(), two = resumed.advance();
      ASSERT_TRUE(std::holds_alternative<Step>(one) && std::holds_alternative<Step>(two));
      EXPECT_EQ(std::get<Step>(one).number, std::get<Step>(two).number);
      EXPECT_EQ(std::get<Step>(one).iterations.size(), std::get<Step>(two).iterations.size());
      ASSERT_TRUE((stepper.state().displacement.array() == resumed.state().displacement.array()).all())
          << "at load " << stepper.state().load;
      ASSERT_EQ(stepper.state().energies.imbalance(), resumed.state().energies.imbalance());
    }
    patterns += stepper.assembler().pattern_version() - pattern;
  }
  EXPECT_GT(patterns, 0) << "the test must see the pattern change";
}

}  // namespace
}  // namespace cleft::solve
