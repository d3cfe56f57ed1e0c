// Where increments of the load end.
#include "cleft/solve/stepping.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "small_models.hpp"

namespace cleft::solve {
namespace {

using Loads = std::vector<double>;

// A body without a crack, pressed.
assembly::Model solid() {
  assembly::Model m;
  m.mesh = geometry::structured_mesh({0, 0, 1, 1}, {2, 2}, geometry::Diagonal::Right);
  models::discretise(m, 1.0, 0.0, contact::NegativeSide::Left, 1e10);
  m.prescribed = {models::hold(m, "bottom", {0, 0}), models::hold(m, "top", {0, -0.05})};
  return m;
}

Loads loads_of(LoadStepper& stepper) {
  Loads loads;
  while (!stepper.done()) {
    const auto outcome = stepper.advance();
    if (const auto* failure = std::get_if<assembly::Failure>(&outcome)) {
      ADD_FAILURE() << name_of(failure->kind);
      break;
    }
    loads.push_back(stepper.state().load);
  }
  return loads;
}

Loads loads_with(int steps, Loads outputs, Loads kinks, double accuracy = 0.0, Control control = Control::Load) {
  const assembly::Model model = solid();
  StepControls controls = models::in_steps(steps, std::move(outputs));
  controls.kinks = std::move(kinks);
  controls.accuracy = accuracy;
  controls.control = control;
  LoadStepper stepper(model, controls);
  return loads_of(stepper);
}

TEST(Stepping, EndsAtOutputsAndTurnsOfTheLoadAndGoesOnAsBefore) {
  for (const Control control : {Control::Load, Control::Path}) {
    EXPECT_EQ(loads_with(4, {0.26}, {}, 0.0, control), (Loads{0.25, 0.26, 0.5, 0.75, 1.0}));
    EXPECT_EQ(loads_with(4, {}, {0.26, 0.6}, 0.0, control), (Loads{0.25, 0.26, 0.5, 0.6, 0.75, 1.0}));
  }
}

TEST(Stepping, PlannedLoadsGiveWayToOutputsAndKinksBesideThem) {
  EXPECT_EQ(loads_with(3, {0.3333, 0.6667, 1.0}, {}), (Loads{0.3333, 0.6667, 1.0}));
  EXPECT_EQ(loads_with(3, {}, {0.333, 0.667}), (Loads{0.333, 0.667, 1.0}));
  EXPECT_EQ(loads_with(10, {0.0995, 0.2005, 1.0}, {}).size(), 10u) << "the way between two of them is made at once";
  EXPECT_EQ(loads_with(2, {0.49}, {}), (Loads{0.49, 0.5, 1.0})) << "farther than a hundredth of an increment";
}

TEST(Stepping, TellsTurnsFromOutputsUpToRounding) {
  const double third = 1.0 / 3.0;
  EXPECT_EQ(loads_with(2, {third}, {0.333333, 0.3333333}), (Loads{third, 0.5, 1.0}));
  EXPECT_EQ(loads_with(2, {0.3}, {0.1 + 0.2}), (Loads{0.3, 0.5, 1.0}));
  EXPECT_EQ(loads_with(2, {third}, {0.3333}), (Loads{0.3333, third, 0.5, 1.0})) << "a turn is never passed by";
  EXPECT_EQ(loads_with(1, {}, {0.5, 0.500001}), (Loads{0.5, 0.500001, 1.0})) << "a jump has two";
  EXPECT_EQ(loads_with(2, {}, {1.0 - 1e-9}), (Loads{0.5, 1.0}));
}

TEST(Stepping, KeepsTheSizeThatIsWantedApartFromTheOneThatIsTaken) {
  const assembly::Model model = models::block(8, contact::NegativeSide::Left);
  StepControls controls = models::in_steps(20, {0.051});
  LoadStepper stepper(model, controls);
  for (const double load : {0.05, 0.051, 0.1}) {
    ASSERT_TRUE(std::holds_alternative<Step>(stepper.advance()));
    EXPECT_EQ(stepper.state().load, load);
    EXPECT_EQ(stepper.place().step, 0.05);
  }
  Event close;
  close.before = 0.101;
  ASSERT_TRUE(std::holds_alternative<Step>(stepper.advance({}, close)));
  EXPECT_EQ(stepper.state().load, 0.101);
  EXPECT_EQ(stepper.place().step, 0.05);
}

TEST(Stepping, HalvesWhatWasTakenAndGrowsAgainByTwo) {
  const assembly::Model model = models::block(8, contact::NegativeSide::Left);
  StepControls controls = models::in_steps(4);
  controls.newton.max_iterations = 4;  // too few for some
  LoadStepper stepper(model, controls);
  double wanted = stepper.place().step;
  int cut = 0;
  while (!stepper.done()) {
    const double before = stepper.state().load;
    const auto outcome = stepper.advance();
    ASSERT_TRUE(std::holds_alternative<Step>(outcome)) << name_of(std::get<assembly::Failure>(outcome).kind);
    const auto& step = std::get<Step>(outcome);
    const double taken = step.load - before;
    if (step.cuts > 0) {
      ++cut;
      EXPECT_EQ(stepper.place().step, taken);
    } else {
      EXPECT_GE(stepper.place().step, wanted);
      EXPECT_LE(stepper.place().step, std::max(wanted, std::min(2.0 * taken, 0.25)));
    }
    wanted = stepper.place().step;
  }
  EXPECT_GT(cut, 0) << "the test must see a cut";
}

TEST(Stepping, MayCutAnIncrementToAnOutputHoweverNear) {
  const assembly::Model model = models::block(8, contact::NegativeSide::Left);
  StepControls controls = models::in_steps(2, {1e-5});
  controls.newton.max_iterations = 0;  // nothing converges
  LoadStepper stepper(model, controls);
  const auto outcome = stepper.advance();
  ASSERT_TRUE(std::holds_alternative<assembly::Failure>(outcome));
  const auto& last = std::get<assembly::LastIncrement>(std::get<assembly::Failure>(outcome).attempt);
  EXPECT_EQ(last.size, 1e-5 / 64);  // the last one above a hundredth of the way
}

}  // namespace
}  // namespace cleft::solve
