#include "cleft/tangent_check/intermediate_states.hpp"

#include <gtest/gtest.h>

#include <initializer_list>

#include "chosen_states.hpp"
#include "cleft/problem/build.hpp"
#include "cleft/scene/read.hpp"

namespace cleft::tangent_check {
namespace {

struct Plain {
  growth::Evolution body;
  explicit Plain(std::initializer_list<std::string> overrides)
      : Plain(scene::read_scene(std::string(CLEFT_SOURCE_DIR) + "/verification/scenes/plain.toml", overrides)) {}
  explicit Plain(const problem::Specification& scene) : body(growth::Evolution(scene, problem::build_model(scene))) {}
};

std::vector<double> loads(Plain& run, int states) {
  std::vector<double> out;
  see_chosen_states(run.body, states, [&](const IntermediateState& b) {
    EXPECT_LT(b.before.load, b.load);
    out.push_back(b.load);
  });
  return out;
}

void expect_near(const std::vector<double>& got, const std::vector<double>& expected) {
  ASSERT_EQ(got.size(), expected.size());
  for (std::size_t k = 0; k < got.size(); ++k) EXPECT_NEAR(got[k], expected[k], 1e-12);
}

TEST(VisitBetween, StopsEvenlyOverTheLoadInsideOfIncrements) {
  Plain run({"mesh.cells=[2,4]", "loading.steps=10"});
  expect_near(loads(run, 2), {0.237, 0.737});  // in the increments up to 0.3 and 0.8
}

TEST(VisitBetween, StopsOnceAnIncrementWhereMoreStatesAreAskedFor) {
  Plain run({"mesh.cells=[2,4]", "loading.steps=2"});
  expect_near(loads(run, 100), {0.185, 0.685});
}

TEST(VisitBetween, HandsOverThePartOfTheWayAndTheHistoryBehindIt) {
  Plain run({"mesh.cells=[2,4]", "loading.steps=4"});
  EXPECT_FALSE(visit_increments(run.body, [&](const IntermediateState& b) {
    if (b.after < 0.4) return true;
    EXPECT_NEAR(b.before.load, 0.25, 1e-12);
    const VecX& after = run.body.stepper().state().displacement;
    EXPECT_LT((b.displacement - b.before.displacement - 0.37 * (after - b.before.displacement)).norm(), 1e-15);
    EXPECT_GT((after - b.before.displacement).norm(), 1e-4);
    return false;
  }));
}

TEST(VisitBetween, EndsWhereTheVisitorHasSeenEnough) {
  Plain run({"mesh.cells=[2,4]", "loading.steps=10"});
  int visits = 0;
  EXPECT_FALSE(visit_increments(run.body, [&](const IntermediateState&) { return ++visits < 2; }));
  EXPECT_EQ(visits, 2);
  EXPECT_NEAR(run.body.stepper().state().load, 0.2, 1e-12);
}

TEST(VisitBetween, StopsOnceMoreWhereTheRunFails) {
  Plain run({"mesh.cells=[2,4]", "solver.max_iterations=1", "solver.min_step=0.04"});
  std::vector<double> seen;
  const auto failure = visit_increments(run.body, [&](const IntermediateState& b) {
    seen.push_back(b.load);
    EXPECT_GT(b.displacement.norm(), 0.0);
    return true;
  });
  ASSERT_TRUE(failure);
  EXPECT_EQ(failure->kind, assembly::FailureKind::NoConvergence);
  ASSERT_EQ(seen.size(), 1u);
  EXPECT_GT(seen[0], 0.0);
  EXPECT_LT(seen[0], 0.1);
}

TEST(VisitIncrements, StopsInEveryIncrementAndKnowsHowLongItTakes) {
  Plain run({"mesh.cells=[2,4]", "loading.steps=4"});
  std::vector<double> seen, after;
  EXPECT_FALSE(visit_increments(run.body, [&](const IntermediateState& b) {
    EXPECT_EQ(b.of, IntermediateState::Of::Increment);
    EXPECT_NEAR(b.before.history.duration, 0.25, 1e-12);
    seen.push_back(b.load);
    after.push_back(b.after);
    return true;
  }));
  expect_near(seen, {0.0925, 0.3425, 0.5925, 0.8425});
  expect_near(after, {0.25, 0.5, 0.75, 1.0});
}

}  // namespace
}  // namespace cleft::tangent_check
