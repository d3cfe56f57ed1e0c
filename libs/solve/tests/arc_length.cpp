// Limit points: the path of solutions beyond them, and back.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "cleft/solve/stepping.hpp"
#include "small_models.hpp"

namespace cleft::solve {
namespace {

constexpr double kBarYoung = 1.0e4, kPoisson = 0.25, kTraction = 5000.0;

assembly::Prescribed hold_component(const assembly::Model& m, const std::string& on, int component) {
  assembly::Prescribed p{on,
                         geometry::boundary_nodes(m.mesh, on),
                         {component == 0, component == 1},
                         [](const Vec2&, geometry::MaybeSide, double) { return Vec2(Vec2::Zero()); }};
  return p;
}

// A dead load that rises with the load up to a turn and falls beyond it.
double factor(double load, double turn) { return std::fmin(load, 2.0 * turn - load); }

// A bar of unit length under a dead traction at its end: P = E/(1 - nu^2) ln l / l, which is largest at l = e.
assembly::Model bar(double turn = 1.0) {
  assembly::Model m;
  m.mesh = geometry::structured_mesh({0, 0, 0.5, 1.0}, {2, 3}, geometry::Diagonal::Right);
  models::discretise(m, 1.0, 0.0, contact::NegativeSide::Left, kBarYoung);
  m.materials = {constitutive::Hencky{constitutive::lame(kBarYoung, kPoisson)}};
  m.prescribed = {hold_component(m, "bottom", 1), hold_component(m, "left", 0)};
  VecX force = VecX::Zero(m.unknowns.components());
  for (const auto& [i, j] : m.mesh.boundaries.at("top")) {
    const double half = 0.5 * (m.mesh.nodes[i] - m.mesh.nodes[j]).norm();
    force[2 * i + 1] += half * kTraction;
    force[2 * j + 1] += half * kTraction;
  }
  m.dead_loads.push_back([force, turn](double load) -> VecX { return factor(load, turn) * force; });
  return m;
}

double nominal_stress(double stretch) { return kBarYoung / (1.0 - kPoisson * kPoisson) * std::log(stretch) / stretch; }

double stretch_of(const assembly::Model& m, const assembly::State& s) {
  return 1.0 + s.displacement[2 * geometry::boundary_nodes(m.mesh, "top").front() + 1];
}

StepControls along_path(int steps) {
  StepControls c;
  c.steps = steps;
  c.control = Control::Path;
  return c;
}

TEST(Path, PassesTheLimitLoadOfABar) {
  const assembly::Model model = bar();
  LoadStepper stepper(model, along_path(20));
  const double limit = nominal_stress(std::numbers::e) / kTraction;  // 0.785
  double highest = 0.0;
  int falling = 0;
  while (stretch_of(model, stepper.state()) < 8.0) {
    const auto outcome = stepper.advance();
    ASSERT_TRUE(std::holds_alternative<Step>(outcome)) << name_of(std::get<assembly::Failure>(outcome).kind);
    const assembly::State& s = stepper.state();
    EXPECT_NEAR(s.load, nominal_stress(stretch_of(model, s)) / kTraction, 1e-7);
    highest = std::max(highest, s.load);
    falling += s.load < s.previous_load;
    ASSERT_LT(std::get<Step>(outcome).number, 200);
  }
  EXPECT_LE(highest, limit * (1 + 1e-7));
  EXPECT_GT(highest, 0.99 * limit);
  EXPECT_GT(falling, 5);
  EXPECT_LT(stepper.state().load, 0.65);
}

TEST(Path, LoadControlStopsAtTheLimitLoadOfABar) {
  const assembly::Model model = bar();
  StepControls controls = along_path(20);
  controls.control = Control::Load;
  LoadStepper stepper(model, controls);
  for (int k = 0; k < 100; ++k)
    if (std::holds_alternative<assembly::Failure>(stepper.advance())) break;
  EXPECT_NEAR(stepper.state().load, nominal_stress(std::numbers::e) / kTraction, 1e-3);
}

// Just below the limit load, where increments of the load fail: the path ends at the turn, and the load falls.
TEST(Path, EndsAtATurnOfTheLoad) {
  constexpr double kTurn = 0.7845;
  const assembly::Model model = bar(kTurn);
  StepControls controls = along_path(4);
  controls.kinks = {kTurn};
  controls.newton.max_iterations = 5;
  LoadStepper stepper(model, controls);
  bool by_path = false, hit = false;
  while (!stepper.done()) {
    const auto outcome = stepper.advance();
    ASSERT_TRUE(std::holds_alternative<Step>(outcome)) << name_of(std::get<assembly::Failure>(outcome).kind);
    const assembly::State& s = stepper.state();
    EXPECT_NEAR(factor(s.load, kTurn), nominal_stress(stretch_of(model, s)) / kTraction, 1e-7);
    by_path = by_path || stepper.place().arc_increment > 0.0;
    hit = hit || s.load == kTurn;
    ASSERT_LT(std::get<Step>(outcome).number, 100);
  }
  EXPECT_TRUE(by_path);
  EXPECT_TRUE(hit);
  EXPECT_LT(stretch_of(model, stepper.state()), std::numbers::e);
}

// The size is counted in increments made last, and that to the output is far shorter than it was wanted.
TEST(Path, GoesOnWithItsSizeAfterAnOutput) {
  const assembly::Model model = bar();
  LoadStepper first(model, along_path(20));
  while (first.place().arc_increment == 0.0) ASSERT_TRUE(std::holds_alternative<Step>(first.advance()));
  StepControls controls = along_path(20);
  controls.outputs = {first.state().load + 1e-5};
  LoadStepper stepper(model, controls);
  stepper.restore(first.state(), first.place());
  ASSERT_TRUE(std::holds_alternative<Step>(stepper.advance()));
  EXPECT_EQ(stepper.state().load, controls.outputs.front());
  EXPECT_GT(stepper.place().arc_increment, 100.0);
  ASSERT_TRUE(std::holds_alternative<Step>(first.advance()));
  ASSERT_TRUE(std::holds_alternative<Step>(stepper.advance()));
  EXPECT_GT(stretch_of(model, stepper.state()), stretch_of(model, first.state()));
}

// Where the load can rise, a run that may follow its path is that of load control, to the last bit.
TEST(Path, CostsNothingWhereTheLoadRises) {
  const assembly::Model model = models::block(8, contact::NegativeSide::Left);
  StepControls controls = along_path(10);
  LoadStepper by_path(model, controls);
  controls.control = Control::Load;
  LoadStepper by_load(model, controls);
  for (int k = 0; k < 4; ++k) {
    ASSERT_TRUE(std::holds_alternative<Step>(by_load.advance()));
    ASSERT_TRUE(std::holds_alternative<Step>(by_path.advance()));
  }
  EXPECT_EQ(by_load.state().load, by_path.state().load);
  EXPECT_EQ(by_load.state().displacement, by_path.state().displacement);
  EXPECT_EQ(by_load.state().progress.size(), 0);
}

// The coordinate of the path grows by one in the increment that defines it.
TEST(Path, CoordinateIsThatOfTheLastIncrement) {
  assembly::Model model = models::block(8, contact::NegativeSide::Left);
  const constitutive::DruckerPrager cone{constitutive::lame(1e10, 0.25), 8e8, 0.8, 0.7, 0.0};
  model.materials = {constitutive::FinitePlastic{cone}};
  LoadStepper stepper(model, along_path(20));
  for (int k = 0; k < 8; ++k) {
    ASSERT_TRUE(std::holds_alternative<Step>(stepper.advance()));
    const assembly::State& s = stepper.state();
    EXPECT_NEAR(s.progress.dot(s.displacement - s.previous_displacement), 1.0, 1e-12);
  }
}

// Rounding leaves no direction where nothing moves: the path keeps the one before, and its end comes.
TEST(Path, EndsOnAPlateauWithTheLoadThatStaysAndTheMotionThatGoesOn) {
  assembly::Model model = bar();
  const constitutive::DruckerPrager j2 = constitutive::von_mises(constitutive::lame(kBarYoung, kPoisson), 100.0);
  model.materials = {constitutive::SmallPlastic{j2}};
  LoadStepper stepper(model, along_path(200));
  std::variant<Step, assembly::Failure> outcome;
  while (std::holds_alternative<Step>(outcome = stepper.advance())) ASSERT_LT(std::get<Step>(outcome).number, 100);
  EXPECT_EQ(std::get<assembly::Failure>(outcome).kind, assembly::FailureKind::Plateau);
  const double limit = 200.0 / std::sqrt(3.0) / kTraction;
  EXPECT_NEAR(stepper.state().load, limit, 1e-6);
  EXPECT_GE(stepper.place().plateau.travelled, stepper.place().plateau.extent);
  EXPECT_NEAR(stepper.place().plateau.load, limit, 1e-4 * limit);
  EXPECT_EQ(std::get<assembly::Failure>(stepper.advance()).kind, assembly::FailureKind::Plateau) << "and stays ended";
}

// An iterate beyond load 1 asks the loads how they would go on.
TEST(Path, PassesLoadOneOnItsWayThere) {
  assembly::Model model = bar(2.0);
  model.materials = {constitutive::Hencky{constitutive::lame(kBarYoung * 1.66, kPoisson)}};  // limit load 1.3
  model.dead_loads = {[load = model.dead_loads[0]](double at) { return load(std::fmin(at, 1.0)); }};
  LoadStepper stepper(model, along_path(4));
  for (int k = 0; k < 3; ++k) ASSERT_TRUE(std::holds_alternative<Step>(stepper.advance()));
  StepPlace place = stepper.place();
  place.arc_increment = 2.0;  // to a load of about 1.06
  stepper.restore(stepper.state(), place);
  const auto outcome = stepper.advance();
  ASSERT_TRUE(std::holds_alternative<Step>(outcome)) << name_of(std::get<assembly::Failure>(outcome).kind);
  EXPECT_EQ(std::get<Step>(outcome).cuts, 0);
  EXPECT_EQ(stepper.state().load, 1.0);
}

TEST(Path, EndsWhereItWandersAmongLoadsThatItHasPassed) {
  const assembly::Model model = bar();
  LoadStepper stepper(model, along_path(20));
  for (int k = 0; k < 40; ++k) ASSERT_TRUE(std::holds_alternative<Step>(stepper.advance()));
  StepPlace place = stepper.place();
  EXPECT_GT(place.wandered, 5) << "on the falling branch";
  place.wandered = 1000;
  stepper.restore(stepper.state(), place);
  ASSERT_TRUE(std::holds_alternative<Step>(stepper.advance()));
  EXPECT_EQ(std::get<assembly::Failure>(stepper.advance()).kind, assembly::FailureKind::Wanders);
}

// Sent back the way it came a path finds nothing but elastic unloading, and says so.
TEST(Path, EndsWhereTheBodyOnlyUnloads) {
  assembly::Model model = bar();
  const constitutive::DruckerPrager j2 = constitutive::von_mises(constitutive::lame(kBarYoung, kPoisson), 100.0, 10.0);
  model.materials = {constitutive::SmallPlastic{j2}};
  LoadStepper stepper(model, along_path(200));
  while (stepper.state().history.plastic[0].accumulated == 0.0)
    ASSERT_TRUE(std::holds_alternative<Step>(stepper.advance()));
  assembly::State state = stepper.state();
  StepPlace place = stepper.place();
  place.arc_increment = 1.0;
  place.longest = (state.displacement - state.previous_displacement).cwiseAbs().maxCoeff();
  state.progress = -state.progress;
  state.previous_displacement += 2.0 * (state.displacement - state.previous_displacement);
  state.previous_load += 2.0 * (state.load - state.previous_load);
  const double load = state.load;
  stepper.restore(std::move(state), place);
  const auto outcome = stepper.advance();
  ASSERT_TRUE(std::holds_alternative<assembly::Failure>(outcome));
  EXPECT_EQ(std::get<assembly::Failure>(outcome).kind, assembly::FailureKind::Unloads)
      << name_of(std::get<assembly::Failure>(outcome).kind);
  EXPECT_EQ(stepper.state().load, load);
}

// Snap-back: both the load and the displacement at the boundary fall, and rise again.
TEST(Path, FollowsAYieldingBlockBackAndHitsItsOutputs) {
  assembly::Model model = models::block(32, contact::NegativeSide::Left);
  const constitutive::DruckerPrager cone{constitutive::lame(1e10, 0.25), 1.5e9, 0.8, 0.7, 0.0};
  model.materials = {constitutive::FinitePlastic{cone}};
  StepControls controls = along_path(50);
  controls.outputs = {0.25, 0.53, 0.5501};
  LoadStepper stepper(model, controls);
  std::vector<double> outputs;
  int falling = 0;
  while (stepper.state().load < 0.56) {
    const auto outcome = stepper.advance();
    ASSERT_TRUE(std::holds_alternative<Step>(outcome)) << name_of(std::get<assembly::Failure>(outcome).kind);
    const auto& step = std::get<Step>(outcome);
    ASSERT_LT(step.number, 100);
    if (step.is_output) outputs.push_back(step.load);
    falling += step.load < stepper.state().previous_load;
    EXPECT_LE(step.left.residual, 1e-8);
  }
  EXPECT_EQ(outputs, controls.outputs);
  EXPECT_GE(falling, 3);
  const assembly::Energies& e = stepper.state().energies;
  EXPECT_NEAR(e.imbalance(), 0.0, 0.01 * e.external_work);
}

}  // namespace
}  // namespace cleft::solve
