#include "cleft/growth/evolution.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "bodies.hpp"
#include "cleft/geometry/advance.hpp"
#include "cleft/support/error.hpp"

namespace cleft::growth {
namespace {

using bodies::edge_crack;

GrowthLaw rankine(double strength, double advance, int most = 1000) {
  GrowthLaw law{Rankine{strength, 0.12}};
  law.advance = advance;
  law.max_advances = most;
  return law;
}

TEST(Evolution, WithoutALawIsTheLoadStepper) {
  const auto square = edge_crack();
  Evolution body = square.stationary(4);
  const auto run = bodies::run(body);
  const assembly::Model model = square();
  solve::LoadStepper stepper(model, bodies::in_steps(4));
  while (!stepper.done()) ASSERT_EQ(stepper.advance().index(), 0u);
  EXPECT_EQ(run.steps.size(), 4u);
  EXPECT_EQ(body.stepper().state().displacement, stepper.state().displacement);
  EXPECT_TRUE(body.record().points.empty());
}

TEST(Evolution, FindsTheLoadOfGrowthWhateverTheIncrements) {
  const auto square = edge_crack();
  std::vector<double> loads;
  for (const int steps : {2, 5, 20, 40}) {
    Evolution body = square.evolution(rankine(6e7, 0.1, 1), steps);
    const auto run = bodies::run(body);
    ASSERT_FALSE(run.failure) << name_of(run.failure->kind);
    const auto grown = run.loads_of_growth();
    ASSERT_EQ(grown.size(), 1u);
    loads.push_back(grown[0]);
  }
  for (const double load : loads) EXPECT_NEAR(load, loads.back(), 1e-4);
  EXPECT_GT(loads.back(), 0.05);
  EXPECT_LT(loads.back(), 0.95);
}

TEST(Evolution, SaysThatWhatHasGrownCannotBeCut) {
  auto square = edge_crack();
  square.cracks[0].tip_radius = 0.2;
  square.loaded = "right";  // which the ball of the tip must not reach
  Evolution body = square.evolution(rankine(6e7, 0.5, 1), 20);
  const auto run = bodies::run(body);
  ASSERT_TRUE(run.failure);
  EXPECT_EQ(run.failure->kind, assembly::FailureKind::Refused);
  EXPECT_NE(std::get<assembly::RefusedCracks>(run.failure->finding).why.find("reaches the boundary 'right'"),
            std::string::npos);
  ASSERT_EQ(run.failure->grown.size(), 1U);
  EXPECT_EQ(run.failure->grown[0].tip.crack, 0);
}

TEST(Evolution, GrowsAtOneAndHardlyBeyondIt) {
  for (const double tolerance : {1e-2, 1e-3, 1e-5}) {
    GrowthLaw law = rankine(6e7, 0.1, 1);
    law.load_tolerance = tolerance;
    Evolution body = edge_crack().evolution(law, 3);
    double below = 0.0;
    for (const auto& step : bodies::run(body).steps) {
      if (step.advances.empty()) {
        below = step.load;
        continue;
      }
      const double measure = step.advances[0].demand.ratio;
      EXPECT_GE(measure, 1.0);
      EXPECT_LE(measure, 1.0 + 2.0 * tolerance / below);  // the demand grows in proportion to the load
    }
  }
}

TEST(Evolution, AdvancesSeveralTimesAtOneLoadUntilTheBodyIsRelieved) {
  auto square = edge_crack();
  square.cracks[0].points[1].x() = 0.12;  // while it is short, every advance makes it weaker
  square.cells = {20, 20};
  Evolution body = square.evolution(rankine(6e7, 0.08, 4), 10);
  const auto run = bodies::run(body);
  ASSERT_FALSE(run.failure);
  const auto advances = run.advances();
  ASSERT_EQ(advances.size(), 4u);
  for (int k = 0; k < 4; ++k) {
    EXPECT_EQ(advances[static_cast<std::size_t>(k)].number, k + 1);
    EXPECT_NEAR(advances[static_cast<std::size_t>(k)].length, 0.08, 1e-12);
    EXPECT_NEAR(advances[static_cast<std::size_t>(k)].angle, 0.0, 0.2);  // an opening crack goes straight on
  }
  EXPECT_EQ(advances.back().stop, Stop::MaxAdvances);
  const auto loads = run.loads_of_growth();
  EXPECT_EQ(loads[0], loads[1]);
  EXPECT_LE(loads[1], loads[3]);
  EXPECT_EQ(body.record().tips[0][1].advances, 4);
  EXPECT_EQ(body.record().tips[0][0].advances, 0);  // at the boundary
}

// An edge crack that turns, since the top moves aside as well.
bodies::Square turning_crack() {
  auto square = edge_crack();
  square.cells = {20, 20};
  square.top = {0.008, 0.01};
  return square;
}

// The first step of growth.
Step first_growth(Evolution& body) {
  while (!body.done()) {
    auto outcome = body.advance();
    if (auto* failure = std::get_if<assembly::Failure>(&outcome)) {
      ADD_FAILURE() << name_of(failure->kind);
      return {};
    }
    if (auto& step = std::get<Step>(outcome); !step.advances.empty()) return step;
  }
  ADD_FAILURE() << "nothing grows";
  return {};
}

TEST(Evolution, CorrectsTheDirectionByThatAskedForAtTheEndOfAnAdvance) {
  GrowthLaw law = rankine(6e7, 0.1, 1);
  Evolution tried = turning_crack().evolution(law, 4);
  const Step once = first_growth(tried);
  ASSERT_EQ(once.advances.size(), 1u);
  const Vec2 before = once.advances[0].demand.ahead;
  const Vec2 after = judge(std::get<Rankine>(law.criterion), tried.stepper().equilibrium(), {0, 1}).ahead;
  ASSERT_GT((after - before).norm(), 0.01);

  law.correct_direction = true;
  Evolution corrected = turning_crack().evolution(law, 4);
  const Step twice = first_growth(corrected);
  ASSERT_EQ(twice.advances.size(), 1u);
  EXPECT_EQ(twice.load, once.load);
  EXPECT_EQ(twice.number, once.number);
  EXPECT_NEAR(twice.advances[0].angle, std::atan2((before + after).y(), (before + after).x()), 1e-9);
  EXPECT_NEAR(twice.advances[0].length, 0.1, 1e-12);
  EXPECT_GE(twice.iterations_before, once.iterations_before + static_cast<int>(once.iterations.size()));
}

// The ball of the tip just reaches the loaded boundary where the corrected advance ends, which bends towards it, and
// just does not where the first one ends.
TEST(Evolution, GoesTheFirstWayWhereTheCorrectedOneIsBarred) {
  auto square = turning_crack();
  square.cracks = {{"main", {{0.0, 0.537}, {0.46, 0.537}}, 0.45554}};
  GrowthLaw law = rankine(6e7, 0.1, 1);
  const auto advance = [&](bool corrected, const char* loaded) {
    law.correct_direction = corrected;
    square.loaded = loaded;
    Evolution body = square.evolution(law, 4);
    const Step step = first_growth(body);
    EXPECT_EQ(step.advances.size(), 1u);
    EXPECT_EQ(body.model().cracks[0].points.back(), step.advances.at(0).point);
    return step.advances.at(0).point;
  };
  const Vec2 first = advance(false, "");
  EXPECT_GT((advance(true, "") - first).norm(), 1e-4);
  EXPECT_EQ(advance(true, "bottom"), first);
}

TEST(Evolution, CutsThroughAtTheBoundaryWhereAnAdvanceIsLongerThanTheLigament) {
  for (const double advance : {0.3, 2.0}) {
    auto square = edge_crack();
    square.cracks[0].points[1].x() = 0.8;
    Evolution body = square.evolution(rankine(2e7, advance), 4);
    const auto run = bodies::run(body);
    ASSERT_FALSE(run.failure) << name_of(run.failure->kind);
    const auto advances = run.advances();
    ASSERT_EQ(advances.size(), 1u);
    EXPECT_EQ(advances[0].stop, Stop::Boundary);
    EXPECT_NEAR(advances[0].point.x(), 1.0, 1e-12);
    EXPECT_EQ(body.model().cut.cracks[0].ends[1].kind, geometry::CrackEnd::Kind::Mouth);
    const auto reactions = body.stepper().reactions();
    EXPECT_LT(reactions[1].norm(), 1.0);  // N/m: nothing holds the halves together
    const auto& energies = body.stepper().state().energies;
    EXPECT_LT(energies.elastic, 1e-9 * energies.external_work);
    EXPECT_NEAR(energies.released, energies.external_work, 2e-3 * energies.external_work);  // of few increments
  }
}

TEST(Evolution, StopsBeforeAnotherCrack) {
  auto square = edge_crack();
  square.cells = {20, 20};
  square.cracks.push_back({"wall", {{0.62, 0.3}, {0.62, 0.72}}});
  Evolution body = square.evolution(rankine(3e7, 0.1), 10);
  const auto run = bodies::run(body);
  ASSERT_FALSE(run.failure) << name_of(run.failure->kind);
  const auto advances = run.advances();
  ASSERT_GE(advances.size(), 2u);
  EXPECT_EQ(advances.back().stop, Stop::Hindered);
  EXPECT_NE(advances.back().hindrance.find("wall"), std::string::npos) << advances.back().hindrance;
  EXPECT_LT(advances.back().point.x(), 0.62);
  EXPECT_GT(advances.back().point.x(), 0.45);  // it came as near as an eighth of the ligament and an element allow
  EXPECT_EQ(body.model().cracks[1].points.size(), 2u);
}

TEST(Evolution, GrowsFromTipsOnElementEdgesAndNodes) {
  for (const Vec2& tip : {Vec2(0.3, 0.5), Vec2(0.35, 0.55), Vec2(0.3, 0.53), Vec2(0.3, 0.5 + 1e-9)}) {
    auto square = edge_crack();
    square.cracks[0].points = {{0.0, tip.y()}, tip};
    Evolution body = square.evolution(rankine(5e7, 0.1, 3), 5);  // advances that end on nodes and edges, too
    const auto run = bodies::run(body);
    ASSERT_FALSE(run.failure) << name_of(run.failure->kind);
    EXPECT_EQ(run.advances().size(), 3u);
    EXPECT_NEAR(run.advances()[0].angle, 0.0, 0.2);
  }
}

TEST(Evolution, SetsFreeWhatTheWorkLeavesUnexplained) {
  Evolution body = edge_crack().evolution(rankine(6e7, 0.1, 2), 50);
  const auto run = bodies::run(body);
  double released = 0.0;
  for (const auto& step : run.steps) {
    EXPECT_TRUE(step.advances.empty() || step.released > 0.0);
    released += step.released;
  }
  const auto& energies = body.stepper().state().energies;
  EXPECT_GT(released, 0.0);
  EXPECT_NEAR(energies.released, released, 1e-12 * released);
  EXPECT_NEAR(energies.imbalance(), 0.0, 1e-3 * energies.external_work);  // the trapezoidal rule over the increments
}

// At its load the crack advances by da; what that sets free is the rate times da as da goes to zero, and the rate is
// the derivative of the stored energy at a fixed top. The increments around it see both.
TEST(Evolution, SetsFreeTheDifferenceOfTwoStationaryCracks) {
  // pulled open, and a closed one that slides without friction
  auto open = edge_crack(), closed = edge_crack();
  open.cells = closed.cells = {20, 20};
  closed.cracks[0].points = {{0.31, 0.3}, {0.69, 0.68}};
  closed.friction = 0.0;
  closed.top = {0.0, -0.01};
  for (const auto& [square, strength, radius] : {std::tuple{open, 6e7, 0.12}, std::tuple{closed, 1e6, 0.06}}) {
    GrowthLaw law{Rankine{strength, radius}};
    law.advance = 0.1;
    law.max_advances = 1;
    Evolution body = square.evolution(law, 10);
    const auto run = bodies::run(body);
    ASSERT_GE(run.advances().size(), 1u);
    const Advance advance = run.advances()[0];
    const double load = run.loads_of_growth()[0];
    const auto energy_of = [&](const std::vector<geometry::Crack>& cracks) {
      const assembly::Model model = square(cracks);
      auto controls = bodies::in_steps(1);
      controls.outputs = {load};
      solve::LoadStepper stepper(model, controls);
      EXPECT_EQ(stepper.advance().index(), 0u);
      EXPECT_EQ(stepper.state().load, load);
      return stepper.state().energies.elastic + stepper.state().energies.contact;
    };
    const double before = energy_of(square.cracks),
                 after = energy_of({geometry::extended(square.cracks[0], advance.tip.end, advance.point)});
    const auto first = std::ranges::find_if(run.steps, [](const Step& step) { return !step.advances.empty(); });
    ASSERT_EQ(first->advances.size(), 1u);
    const double tolerance = square.friction > 0.0 ? 1e-6 : 2e-4;  // closed: pressure works on sloping faces, too
    EXPECT_NEAR(first->released, before - after, tolerance * first->released);
  }
}

// What new faces held is taken away bit by bit where the iteration may not take many steps: the end is the same.
TEST(Evolution, SettlesBitByBitToTheSameEnd) {
  auto square = edge_crack();
  square.top = {0.0, 0.05};
  VecX displacement[2];
  double released[2];
  for (const int k : {0, 1}) {
    if (k == 1) square.max_iterations = 3;
    Evolution body = square.evolution(rankine(1.2e8, 0.3, 1), 400);
    Step grown;
    while (grown.advances.empty()) {
      ASSERT_LT(body.stepper().state().load, 1.0);
      auto outcome = body.advance();
      ASSERT_EQ(outcome.index(), 0u) << name_of(std::get<assembly::Failure>(outcome).kind);
      grown = std::get<Step>(outcome);
    }
    EXPECT_EQ(grown.cuts > 0, k == 1);
    EXPECT_LT(grown.cuts, 12);
    EXPECT_EQ(grown.iterations_before > 0, k == 1);
    displacement[k] = body.stepper().state().displacement;
    released[k] = grown.released;
  }
  ASSERT_EQ(displacement[0].size(), displacement[1].size());
  EXPECT_LT((displacement[1] - displacement[0]).norm(), 1e-6 * displacement[0].norm());
  EXPECT_NEAR(released[1], released[0], 1e-6 * released[0]);
}

// Wings of a closed crack at strains of 1e-4, where both kinematics must agree.
TEST(Evolution, SmallAndFiniteStrainAgreeWhereTheStrainIsSmall) {
  std::vector<double> slip, friction, released, load;
  for (const bool small : {false, true}) {
    bodies::Square square{.cracks = {{"main", {{0.3, 0.29}, {0.7, 0.69}}}}};
    square.cells = {20, 20};
    square.top = {0.0, -1e-4};
    square.solid = bodies::elastic(small ? problem::Kinematics::Small : problem::Kinematics::Finite, 0.3);
    GrowthLaw law{Rankine{1e4, 0.07}};
    law.advance = 0.09;
    law.max_advances = 2;
    Evolution body = square.evolution(law, 10);
    const auto run = bodies::run(body);
    ASSERT_FALSE(run.failure);
    ASSERT_GE(run.advances().size(), 3u);
    load.push_back(run.loads_of_growth().back());
    const auto& state = body.stepper().state();
    double most = 0.0;
    for (const auto& past : state.history.contact) most = std::max(most, past.state.slip);
    slip.push_back(most);
    friction.push_back(state.energies.friction_dissipation);
    released.push_back(state.energies.released);
    EXPECT_GT(released.back(), 0.0);
  }
  EXPECT_NEAR(load[1], load[0], 2e-3);
  EXPECT_NEAR(slip[1], slip[0], 5e-3 * slip[0]);
  EXPECT_NEAR(friction[1], friction[0], 5e-3 * friction[0]);
  EXPECT_NEAR(released[1], released[0], 1e-2 * released[0]);
}

TEST(Evolution, ARestoredRunGoesOnBitForBit) {
  GrowthLaw law = rankine(6e7, 0.08, 3);
  const auto square = edge_crack();
  Evolution whole = square.evolution(law, 6);
  std::vector<Step> steps;
  struct Kept {
    Record record;
    assembly::State state;
    solve::StepPlace place;
    assembly::ReservedCouplings reserved;
  };
  std::vector<Kept> kept;
  while (!whole.done()) {
    const auto& s = whole.stepper();
    kept.push_back({whole.record(), s.state(), s.place(), s.assembler().reserved_couplings()});
    ASSERT_EQ(whole.advance().index(), 0u);
  }
  ASSERT_GT(kept.size(), 8u);
  for (const auto& at : kept) {
    Evolution resumed = square.evolution(law, 6);
    resumed.restore(at.record, at.state, at.place, at.reserved);
    ASSERT_FALSE(bodies::run(resumed).failure);
    EXPECT_EQ(resumed.stepper().state().displacement, whole.stepper().state().displacement) << "from " << at.state.load;
    EXPECT_EQ(resumed.stepper().place().number, whole.stepper().place().number);
    EXPECT_EQ(resumed.record().points, whole.record().points);
  }
}

TEST(Evolution, OnlyTheTipsThatMayGrowDo) {
  auto square = edge_crack();
  square.cracks[0].points = {{0.3, 0.512}, {0.7, 0.512}};
  GrowthLaw law = rankine(5e7, 0.08, 2);
  law.tips = {true, false};
  Evolution body = square.evolution(law, 5);
  const auto run = bodies::run(body);
  ASSERT_EQ(run.advances().size(), 2u);
  EXPECT_EQ(run.advances()[0].tip.end, 0);
  EXPECT_NEAR(std::fabs(run.advances()[0].angle), 3.14, 0.2);  // to the left
  EXPECT_NEAR(body.model().cracks[0].s_first, -0.16, 1e-12);
  EXPECT_EQ(body.model().cracks[0].points.back(), Vec2(0.7, 0.512));
}

TEST(Evolution, ATipWithoutAnAnswerEndsTheRunWhateverTheOthersSay) {
  auto square = edge_crack();
  square.cracks[0].points = {{0.3, 0.512}, {0.7, 0.512}};
  square.cracks.insert(square.cracks.begin(), {"mute", {{0.1, 0.2}, {0.35, 0.2}}});
  const std::vector<std::optional<GrowthLaw>> laws{GrowthLaw{Rankine{6e7, 1e-4}}, rankine(5e7, 0.08, 2)};
  Evolution body = square.evolution(laws, 4);
  const auto run = bodies::run(body);
  ASSERT_TRUE(run.failure);
  const auto& none = std::get<assembly::NoDemand>(run.failure->finding);
  EXPECT_EQ(none.why, assembly::NoDemand::Why::SmallDisc);
  EXPECT_EQ(none.tip.crack, 0) << "mute";
  EXPECT_EQ(none.tip.end, 0);
  EXPECT_TRUE(run.advances().empty());
}

TEST(Evolution, FailsWhereAnElementIsLargerThanTheDisc) {
  for (const double ball : {0.0, 0.2}) {
    auto square = edge_crack();
    square.cracks[0].tip_radius = ball;
    GrowthLaw law{Rankine{6e7, 0.03}};
    law.advance = 0.1;
    Evolution body = square.evolution(law, 2);
    const auto run = bodies::run(body);
    ASSERT_TRUE(run.failure);
    const auto& none = std::get<assembly::NoDemand>(run.failure->finding);
    EXPECT_EQ(none.why, assembly::NoDemand::Why::SmallDisc);
    EXPECT_EQ(none.tip.end, 1);
  }
}

}  // namespace
}  // namespace cleft::growth
