// Increments whose size follows from what the energy balance may miss.
#include <gtest/gtest.h>

#include <algorithm>

#include "small_models.hpp"

namespace cleft::assembly {
namespace {

struct Ride {
  std::vector<double> loads;
  double missed = 0.0;  // of the external work
  Vec2 force;
};

Ride ride(double accuracy, int steps, std::vector<double> kinks = {}) {
  const Model model = models::block(8, contact::NegativeSide::Left);
  StepControls controls = models::in_steps(steps, {0.5});
  controls.accuracy = accuracy;
  controls.kinks = std::move(kinks);
  LoadStepper stepper(model, controls);
  Ride out;
  while (!stepper.done()) {
    const auto outcome = stepper.advance();
    if (std::holds_alternative<Failure>(outcome)) {
      ADD_FAILURE() << describe(std::get<Failure>(outcome));
      return out;
    }
    out.loads.push_back(stepper.state().load);
  }
  const auto& energies = stepper.state().energies;
  out.missed = std::fabs(energies.imbalance()) / energies.external_work;
  out.force = stepper.reactions()[1];
  return out;
}

TEST(Accuracy, IsKeptWithAsFewIncrementsAsItAllows) {
  const Ride fine = ride(0.0, 200);
  std::size_t fewest = fine.loads.size();
  for (const double accuracy : {1e-4, 1e-3, 1e-2}) {
    const Ride r = ride(accuracy, 50);
    EXPECT_LE(r.missed, accuracy);
    EXPECT_LT(r.loads.size(), fewest) << accuracy;
    EXPECT_LT((r.force - fine.force).norm(), accuracy * fine.force.norm());
    fewest = r.loads.size();
  }
  EXPECT_LE(fewest, 15u);
}

TEST(Accuracy, StillHitsOutputsAndTurnsOfTheLoad) {
  const Ride r = ride(1e-2, 20, {0.37});
  for (const double load : {0.37, 0.5, 1.0}) EXPECT_NE(std::find(r.loads.begin(), r.loads.end(), load), r.loads.end());
  const Ride equal = ride(0.0, 4, {0.37});
  EXPECT_EQ(equal.loads, (std::vector{0.25, 0.5, 0.75, 1.0})) << "without an accuracy increments are equal";
}

TEST(Accuracy, LengthensTheIncrementThatWasMadeNotTheOneThatWasPlanned) {
  const Model model = models::block(8, contact::NegativeSide::Left);
  StepControls controls = models::in_steps(50);
  controls.accuracy = 1e-2;
  LoadStepper stepper(model, controls);
  ASSERT_TRUE(std::holds_alternative<Step>(stepper.advance()));
  for (int k = 0; k < 6; ++k) {  // as where the load of a crack's advance is found
    Event close;
    close.before = stepper.state().load + 1e-3;
    ASSERT_TRUE(std::holds_alternative<Step>(stepper.advance({}, close)));
  }
  const double before = stepper.state().load;
  ASSERT_TRUE(std::holds_alternative<Step>(stepper.advance()));
  EXPECT_LE(stepper.state().load - before, 1.0 / 50 + 1e-12);
}

}  // namespace
}  // namespace cleft::assembly
