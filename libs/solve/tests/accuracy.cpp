// Increments whose size follows from what their work may miss.
#include <gtest/gtest.h>

#include <algorithm>

#include "small_models.hpp"
#include "work_error.hpp"

namespace cleft::solve {
namespace {

struct Ride {
  std::vector<double> loads;
  double work = 0.0;  // external, J/m
  Vec2 force;
};

Ride ride(double accuracy, int steps, std::vector<double> kinks = {}) {
  const assembly::Model model = models::block(8, contact::NegativeSide::Left);
  StepControls controls = models::in_steps(steps, {0.5});
  controls.accuracy = accuracy;
  controls.kinks = std::move(kinks);
  LoadStepper stepper(model, controls);
  Ride out;
  while (!stepper.done()) {
    const auto outcome = stepper.advance();
    if (std::holds_alternative<assembly::Failure>(outcome)) {
      ADD_FAILURE() << name_of(std::get<assembly::Failure>(outcome).kind);
      return out;
    }
    out.loads.push_back(stepper.state().load);
  }
  out.work = stepper.state().energies.external_work;
  out.force = stepper.reactions()[1];
  return out;
}

TEST(Accuracy, IsKeptWithAsFewIncrementsAsItAllows) {
  const Ride fine = ride(0.0, 200);
  std::size_t fewest = fine.loads.size();
  for (const double accuracy : {1e-4, 1e-3, 1e-2}) {
    const Ride r = ride(accuracy, 50);
    EXPECT_LE(std::fabs(r.work - fine.work), accuracy * fine.work);
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
  EXPECT_EQ(equal.loads, (std::vector{0.25, 0.37, 0.5, 0.75, 1.0})) << "without an accuracy increments are equal";
}

TEST(Accuracy, LengthensTheIncrementThatWasMadeNotTheOneThatWasPlanned) {
  const assembly::Model model = models::block(8, contact::NegativeSide::Left);
  StepControls controls = models::in_steps(50);
  controls.accuracy = 1e-2;
  LoadStepper stepper(model, controls);
  ASSERT_TRUE(std::holds_alternative<Step>(stepper.advance()));
  const double wanted = stepper.place().step;
  for (int k = 0; k < 6; ++k) {  // as where the load of a crack's advance is found
    Event close;
    close.before = stepper.state().load + 1e-3;
    ASSERT_TRUE(std::holds_alternative<Step>(stepper.advance({}, close)));
  }
  EXPECT_LE(stepper.place().step, wanted);
}

// A block is pressed and dragged there and back: what is stored comes back, and friction turns.
assembly::Model dragged(double& turn) {
  const auto crack = problem::small::crack_with_multipliers({"main", {{-0.001, 0.0401}, {0.041, 0.0401}}}, 0.3,
                                                            contact::NegativeSide::Left);
  assembly::Model m = problem::build_model(problem::small::block({8, 16}, {0, 0}, crack));
  m.prescribed[1].displacement = [&turn](const Vec2&, geometry::MaybeSide, double load) {
    const double along = std::max(0.0, load <= turn ? (load - 0.1) / (turn - 0.1) : (1.0 - load) / (1.0 - turn));
    return Vec2(3e-4 * along, -8e-5 * std::min(1.0, load / 0.1));
  };
  return m;
}

assembly::Energies work_of_drag(int steps, double accuracy, int* increments = nullptr) {
  double turn = 0.55;
  const assembly::Model model = dragged(turn);
  StepControls controls = models::in_steps(steps);
  controls.kinks = {0.1, turn};
  controls.accuracy = accuracy;
  LoadStepper stepper(model, controls);
  std::vector<double> loads;
  while (!stepper.done()) {
    const auto outcome = stepper.advance();
    if (const auto* failure = std::get_if<assembly::Failure>(&outcome)) {
      ADD_FAILURE() << name_of(failure->kind);
      break;
    }
    loads.push_back(stepper.state().load);
  }
  if (increments) *increments = static_cast<int>(loads.size());
  EXPECT_NE(std::find(loads.begin(), loads.end(), turn), loads.end());
  return stepper.state().energies;
}

TEST(Accuracy, HoldsWhereTheLoadTurnsBack) {
  const assembly::Energies fine = work_of_drag(800, 0.0);
  EXPECT_GT(fine.friction_dissipation, 0.4 * fine.external_work);
  for (const double accuracy : {1e-2, 1e-3}) {
    int increments = 0;
    const assembly::Energies e = work_of_drag(100, accuracy, &increments);
    EXPECT_NEAR(e.external_work, fine.external_work, accuracy * fine.external_work);
    EXPECT_NEAR(e.friction_dissipation, fine.friction_dissipation, accuracy * fine.friction_dissipation);
    EXPECT_LT(increments, 60);
  }
}

// The trapezoidal rule is exact where forces and displacements are linear in the load, whatever the increments.
TEST(Accuracy, MissesNothingInALinearBody) {
  const assembly::Model model = models::block(4, contact::NegativeSide::Left);
  assembly::State before = state_at_rest(model), after = before;
  const auto constraints = constraints_of(model);
  const auto at = [&](double load, const VecX& rate) -> VecX { return load * rate; };
  const VecX u = VecX::LinSpaced(before.displacement.size(), -1.0, 2.0),
             f = VecX::LinSpaced(before.prescribed_force.size(), 3.0, -1.0);
  before.previous_load = 0.1;
  before.previous_displacement = at(0.1, u);
  before.previous_prescribed_force = at(0.1, f);
  before.load = 0.15;
  before.displacement = at(0.15, u);
  before.prescribed_force = at(0.15, f);
  after.load = 0.35;
  after.displacement = at(0.35, u);
  after.prescribed_force = at(0.35, f);
  EXPECT_LT(trapezoidal_error(model, constraints, before, after), 1e-12);
  // f = F L^2, u = U L: the rule misses F . U / 6 times the cube of the step
  const auto square = [&](double load) -> VecX { return load * load * f; };
  before.previous_prescribed_force = square(0.1);
  before.prescribed_force = square(0.15);
  after.prescribed_force = square(0.35);
  double rate = 0.0;
  for (std::size_t k = 0; k < constraints.size(); ++k)
    rate += f[static_cast<Eigen::Index>(k)] * u[constraints[k].component];
  EXPECT_NEAR(trapezoidal_error(model, constraints, before, after), std::fabs(rate) * std::pow(0.2, 3) / 6.0,
              1e-12 * std::fabs(rate));
  before.previous_load = before.load;
  EXPECT_EQ(trapezoidal_error(model, constraints, before, after), 0.0) << "nothing led there";
}

}  // namespace
}  // namespace cleft::solve
