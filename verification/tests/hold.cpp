// What is held stays: where nothing prescribed changes, nothing changes, in a thousand increments.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "comparison.hpp"
#include "hard.hpp"

namespace cleft::verification {
namespace {

// Reactions of all boundaries, N/m.
VecX forces(const solve::LoadStepper& stepper) {
  const auto all = stepper.reactions();
  VecX out(2 * static_cast<Index>(all.size()));
  for (std::size_t k = 0; k < all.size(); ++k) out.segment<2>(2 * static_cast<Index>(k)) = all[k];
  return out;
}

void go_to(solve::LoadStepper& stepper, double load) {
  while (stepper.state().load < load - 1e-9) {
    const auto outcome = stepper.advance();
    ASSERT_TRUE(std::holds_alternative<solve::Step>(outcome)) << name_of(std::get<assembly::Failure>(outcome).kind);
  }
}

struct Drift {
  double over_forces = 0.0;
  bool slid = false;
};

// What forces change by from `held` to the end of the load, over the largest of them.
Drift drift_of(const problem::Specification& scene, double held) {
  const auto model = problem::build_model(scene);
  solve::LoadStepper stepper(model, problem::step_controls(scene));
  go_to(stepper, held);
  Drift out;
  for (const auto& past : stepper.state().history.contact) out.slid = out.slid || past.state.slip > 0.0;
  const VecX before = forces(stepper);
  go_to(stepper, 1.0);
  out.over_forces = (forces(stepper) - before).cwiseAbs().maxCoeff() / before.cwiseAbs().maxCoeff();
  return out;
}

struct Contact {
  const char* name;
  const char* keys;
};
class Hold : public testing::TestWithParam<Contact> {};

TEST_P(Hold, OfASlidingCrackChangesNoForceInAThousandIncrements) {
  Case table(fmt::format("hold after sliding, {}", GetParam().name));
  for (const char* side : {"left", "right", "both"})
    for (const char* kinematics : {"finite", "small"}) {
      const Drift drift = drift_of(hard_scene("hold", {fmt::format("crack.joint.contact={}", GetParam().keys),
                                                       fmt::format("crack.joint.negative_side={}", side),
                                                       fmt::format("formulation.kinematics={}", kinematics)}),
                                   0.02);
      EXPECT_TRUE(drift.slid);
      table.compare(fmt::format("{}, {}: change of the forces over them", side, kinematics), drift.over_forces,
                    exact(0), within(1e-12, "what the last iteration before the hold left"));
    }
}

// The upper block sticks out by a quarter of an interval and by less: some nodes lean on their neighbours.
TEST_P(Hold, WithNodesThatLeanOnTheirNeighboursChangesNoForce) {
  Case table(fmt::format("hold past the mouth, {}", GetParam().name));
  for (const double way : {0.11, 0.19, 0.24})
    for (const double friction : {0.3, 1.0}) {
      const Drift drift =
          drift_of(hard_scene("hold", {fmt::format("crack.joint.contact={}", GetParam().keys),
                                       "crack.joint.negative_side=both", fmt::format("boundary.drag.ux={}", way),
                                       fmt::format("crack.joint.friction={}", friction)}),
                   0.02);
      table.compare(fmt::format("way {}, friction {}: change of the forces over them", way, friction),
                    drift.over_forces, exact(0), within(1e-12, "what the last iteration before the hold left"));
    }
}

TEST_P(Hold, OfAPlasticBodyChangesNoForce) {
  const Drift drift = drift_of(hard_scene("hold", {fmt::format("crack.joint.contact={}", GetParam().keys),
                                                   "material.model=j2", "material.yield_stress=5e7"}),
                               0.02);
  EXPECT_LT(drift.over_forces, 1e-12);
}

// Turned once around the forces are what they were.
TEST_P(Hold, OfATurnedBodyChangesNoForce) {
  Case table(fmt::format("a whole turn, {}", GetParam().name));
  for (const char* side : {"right", "both"}) {
    const auto scene =
        scene_of("rotation", {fmt::format("crack.joint.contact={}", GetParam().keys),
                              fmt::format("crack.joint.negative_side={}", side), "boundary.bottom.rotation.degrees=360",
                              "boundary.top.rotation.degrees=360", "loading.steps=80"});
    table.compare(fmt::format("{}: change of the forces over them", side), drift_of(scene, 0.5).over_forces, exact(0),
                  within(1e-9, "the law is objective: what the iteration at residuals of 1e-12 leaves"));
  }
}

// A homogeneous state, pressed and then sheared until it slides.
TEST_P(Hold, AHomogeneousStateDoesNotDependOnTheNumberOfIncrements) {
  Case table(fmt::format("50 and 2000 increments, {}", GetParam().name));
  for (const char* side : {"left", "both"}) {
    const auto end = [&](int steps) {
      const SolvedModel run(hard_scene(
          "hold", {fmt::format("crack.joint.contact={}", GetParam().keys),
                   fmt::format("crack.joint.negative_side={}", side), "material.poisson=0.0",
                   "crack.joint.points=[[0.0, 0.47], [1.0, 0.47]]", "boundary.press.uy=-1e-3", "boundary.drag.ux=4e-3",
                   fmt::format("loading.steps={}", steps), "boundary.press.amplitude=[[0.0, 0.0], [0.5, 1.0]]",
                   "boundary.drag.amplitude=[[0.0, 0.0], [0.5, 0.0], [1.0, 1.0]]"}));
      return forces(run.stepper);
    };
    const VecX few = end(50), many = end(2000);
    table.compare(fmt::format("{}: difference of the forces over them", side),
                  (few - many).cwiseAbs().maxCoeff() / many.cwiseAbs().maxCoeff(), exact(0),
                  within(1e-11, "residuals of 1e-12"));
  }
}

INSTANTIATE_TEST_SUITE_P(Contact, Hold,
                         testing::Values(Contact{"springs", "{method='penalty'}"},
                                         Contact{"mortar", "{method='mortar'}"},
                                         Contact{"mortar without smoothing", "{method='mortar',smoothing=0}"}),
                         [](const auto& c) {
                           return std::string(c.param.name).substr(0, 6) + std::to_string(c.index);
                         });

// Closing after it was moved along while open, a crack has not slid: no friction acts until it does.
TEST_P(Hold, TouchingAfterAShiftWhileOpenBearsNoFriction) {
  Case table(fmt::format("touch after a shift, {}", GetParam().name));
  for (const char* side : {"left", "both"})
    for (const char* kinematics : {"finite", "small"}) {
      const SolvedModel run(hard_scene(
          "hold",
          {fmt::format("crack.joint.contact={}", GetParam().keys), fmt::format("crack.joint.negative_side={}", side),
           fmt::format("formulation.kinematics={}", kinematics), "crack.joint.points=[[0.0, 0.47], [1.0, 0.47]]",
           "material.poisson=0.0", "boundary.press.uy=-1e-3", "boundary.drag.ux=2e-3", "loading.steps=20",
           "boundary.press.amplitude=[[0.0, 0.0], [0.2, -1.0], [0.6, -1.0], [0.8, 1.0], [1.0, 1.0]]",
           "boundary.drag.amplitude=[[0.0, 0.0], [0.2, 0.0], [0.6, 1.0], [1.0, 1.0]]"}));
      const VecX all = forces(run.stepper);
      const double shear = std::fabs(all[4]), pressed = std::fabs(all[3]);
      EXPECT_GT(pressed, 1e6);
      const bool small = std::string(kinematics) == "small";
      table.compare(fmt::format("{}, {}: shear over pressure", side, kinematics), shear / pressed, exact(0),
                    small ? within(1e-12, "rounding")
                          : within(2e-3, "the blocks are pressed off their middles, by this part of their width"));
    }
}

}  // namespace
}  // namespace cleft::verification
