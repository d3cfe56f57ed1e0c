// Bodies whose answer is known without a mesh: pressed, sheared and torn apart across a crack.
#include <gtest/gtest.h>

#include "cleft/solve/stepping.hpp"
#include "small_models.hpp"

namespace cleft::solve {
namespace {

constexpr double kYoung = 1e6;

// A unit square with a crack through it (unless there is none); bottom held, top moved.
assembly::Model square(bool cracked, double penalty_scale, double friction, const Vec2& top,
                       contact::NegativeSide side = contact::NegativeSide::Right) {
  assembly::Model m;
  m.mesh = geometry::structured_mesh({0, 0, 1, 1}, {6, 6}, geometry::Diagonal::Right);
  if (cracked) m.cracks = {{"through", {{0.0, 0.43}, {1.0, 0.58}}}};
  models::discretise(m, penalty_scale, friction, side, kYoung);
  m.prescribed = {models::hold(m, "bottom", {0, 0}), models::hold(m, "top", top)};
  return m;
}

void finish(LoadStepper& stepper) {
  while (!stepper.done()) {
    const auto outcome = stepper.advance();
    ASSERT_TRUE(std::holds_alternative<Step>(outcome)) << name_of(std::get<assembly::Failure>(outcome).kind);
  }
}

class Patch : public testing::TestWithParam<contact::NegativeSide> {};
INSTANTIATE_TEST_SUITE_P(Sides, Patch,
                         testing::Values(contact::NegativeSide::Left, contact::NegativeSide::Right,
                                         contact::NegativeSide::Both));

TEST_P(Patch, ACrackThatSticksIsAsGoodAsNoneUpToTheSofteningOfItsPenalty) {
  // pressed evenly between smooth plates, so that the uncracked field is exact on any mesh
  const auto press = [](assembly::Model model) {
    model.prescribed = {models::hold(model, "bottom", {0, 0}), models::hold(model, "top", {0, -0.01}),
                        models::hold(model, "left", {0, 0})};
    model.prescribed[0].component = model.prescribed[1].component = {false, true};
    model.prescribed[2].component = {true, false};
    return model;
  };
  const assembly::Model whole = press(square(false, 0, 0, {0, 0}));
  LoadStepper reference(whole, models::in_steps(2));
  ASSERT_NO_FATAL_FAILURE(finish(reference));
  const double force = reference.reactions()[1].y();
  double last = 0.0;
  for (const double scale : {10.0, 100.0, 1000.0}) {
    const assembly::Model model = press(square(true, scale, 10.0, {0, 0}, GetParam()));
    LoadStepper stepper(model, models::in_steps(2));
    ASSERT_NO_FATAL_FAILURE(finish(stepper));
    for (const auto& pair : stepper.pairs()) EXPECT_EQ(pair.state.traction.status, contact::Status::Stick);
    const double softening = 1.0 - stepper.reactions()[1].y() / force;
    // a spring eps = scale E / h in series with a unit column of about E: h / scale
    EXPECT_GT(softening, 0.0);
    EXPECT_LT(softening, 1.5 * model.surfaces.element_size / scale);
    if (last > 0.0) {
      EXPECT_NEAR(last / softening, 10.0, 0.3);
    }
    last = softening;
  }
}

TEST_P(Patch, WithoutFrictionAFlatCrackSlidesFreely) {
  assembly::Model model = square(true, 100.0, 0.0, {0.05, -0.01}, GetParam());
  model.cracks = {{"flat", {{0.0, 0.51}, {1.0, 0.51}}}};
  models::discretise(model, 100.0, 0.0, GetParam(), kYoung);
  LoadStepper stepper(model, models::in_steps(5));
  ASSERT_NO_FATAL_FAILURE(finish(stepper));
  const Vec2 force = stepper.reactions()[1];
  EXPECT_LT(force.y(), -0.009 * kYoung);
  EXPECT_LT(std::fabs(force.x()), 0.03 * std::fabs(force.y()));
  for (const auto& pair : stepper.pairs()) EXPECT_EQ(pair.state.traction.tangential, 0.0);
}

TEST_P(Patch, CoulombsLawHoldsForTheResultantsOfAFlatSlidingCrack) {
  assembly::Model model = square(true, 100.0, 0.0, {0.05, -0.01}, GetParam());
  model.cracks = {{"flat", {{0.0, 0.51}, {1.0, 0.51}}}};
  models::discretise(model, 100.0, 0.2, GetParam(), kYoung);
  LoadStepper stepper(model, models::in_steps(10));
  ASSERT_NO_FATAL_FAILURE(finish(stepper));
  const Vec2 force = stepper.reactions()[1];
  EXPECT_NEAR(force.x() / -force.y(), 0.2, 0.02);
}

TEST(Failures, ABodyThatFloatsIsReportedAndTheStateStaysAtWhatConverged) {
  // nothing holds the upper half but the crack, and a dead load lifts it off
  assembly::Model model = square(true, 1.0, 0.3, {0, 0});
  model.prescribed.pop_back();
  const auto top = geometry::boundary_nodes(model.mesh, "top");
  const auto size = model.unknowns.components();
  model.dead_loads.emplace_back([top, size](double load) {
    VecX force = VecX::Zero(size);
    for (const Index node : top) force[2 * node + 1] = 1e3 * load;
    return force;
  });
  StepControls controls = models::in_steps(1);
  controls.min_step = 0.1;
  LoadStepper stepper(model, controls);
  std::variant<Step, assembly::Failure> outcome;
  while (!stepper.done() && std::holds_alternative<Step>(outcome = stepper.advance())) {
  }
  ASSERT_TRUE(std::holds_alternative<assembly::Failure>(outcome));
  const auto& failure = std::get<assembly::Failure>(outcome);
  EXPECT_TRUE(failure.kind == assembly::FailureKind::Singular || failure.kind == assembly::FailureKind::NotFinite)
      << name_of(failure.kind);
  const auto* far = std::get_if<assembly::FarCorrection>(&failure.finding);
  ASSERT_TRUE(far);
  EXPECT_EQ(far->at.of, assembly::UnknownPosition::Of::Displacement);
  EXPECT_EQ(far->at.reference, model.mesh.nodes.at(static_cast<std::size_t>(far->at.node)));
  EXPECT_EQ(stepper.state().load, 0.0);
  EXPECT_EQ(stepper.state().displacement.norm(), 0.0);
}

}  // namespace
}  // namespace cleft::solve
