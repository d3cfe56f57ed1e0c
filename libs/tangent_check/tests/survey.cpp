#include "cleft/tangent_check/survey.hpp"

#include <gtest/gtest.h>

#include "cleft/problem/build.hpp"
#include "cleft/scene/read.hpp"

namespace cleft::tangent_check {
namespace {

struct Surveyed {
  TangentReport report;
  int seen = 0;
  std::optional<assembly::Failure> failure;

  Surveyed(const std::string& scene, const std::vector<std::string>& overrides, int states = 3) {
    const auto read =
        scene::read_scene(std::string(CLEFT_SOURCE_DIR) + "/verification/scenes/" + scene + ".toml", overrides);
    growth::Evolution body(read, problem::build_model(read));
    failure = survey(body, {states, 1e-6}, report, [&](const IntermediateState&, const TangentReport&) { ++seen; });
  }
};

// The crack of the block slides in every increment: nothing sticks but on the way back.
TEST(Survey, ComesToEveryBranchThatTheSceneHas) {
  const Surveyed block("block", {"mesh.cells=[8,16]"});
  EXPECT_FALSE(block.failure);
  EXPECT_TRUE(block.report.not_visited().empty());
  EXPECT_TRUE(block.report.has_judged("stick"));
  EXPECT_TRUE(block.report.gaps().empty());
  EXPECT_LT(block.report.worst(), 1e-8);
  EXPECT_EQ(block.seen, block.report.states);
  EXPECT_GT(block.report.states, 3) << "the chosen ones, and those where a branch is new";
}

TEST(Survey, SwellsABodyThatYieldsToItsApex) {
  for (const char* kinematics : {"small", "finite"}) {
    const Surveyed pressed("squeezed", {"formulation.f_bar=false", "loading.steps=10",
                                        std::string("formulation.kinematics=") + kinematics});
    EXPECT_FALSE(pressed.failure);
    EXPECT_TRUE(pressed.report.not_visited().empty()) << kinematics;
    EXPECT_TRUE(pressed.report.has_judged("apex")) << kinematics;
    EXPECT_LT(pressed.report.worst(), 1e-7) << kinematics;
  }
}

TEST(Survey, TestsTheRemainderInEveryIncrement) {
  const Surveyed pressed("plain", {"mesh.cells=[2,4]", "loading.steps=10"}, 1);
  EXPECT_EQ(pressed.report.taylor.states + pressed.report.taylor.unclear, 10);
  EXPECT_NEAR(pressed.report.taylor.order, 2.0, 0.05);
  EXPECT_LT(pressed.report.taylor.first_order, 1e-7);
}

TEST(Survey, JudgesWhereTheRunFails) {
  const Surveyed stopped("plain", {"mesh.cells=[2,4]", "solver.max_iterations=1", "solver.min_step=0.04"});
  ASSERT_TRUE(stopped.failure);
  EXPECT_EQ(stopped.failure->kind, assembly::FailureKind::NoConvergence);
  EXPECT_EQ(stopped.report.states, 1);
}

TEST(BranchWords, NameBlocksByTheirWords) {
  for (const char* words : {"apex", "stick", "tip cone", "viscous", "mixed", "tie", "multiplier forces", "mouth"})
    EXPECT_TRUE(names_a_branch(all_branches(), words)) << words;
  for (const char* words : {"", "apx", "cone stick", "patch open"})
    EXPECT_FALSE(names_a_branch(all_branches(), words)) << words;
  TangentReport report;
  report.blocks["tip cone left"].entries = 4;
  report.blocks["bulk apex"].left_out = 4;
  EXPECT_TRUE(report.has_judged("cone"));
  EXPECT_TRUE(report.has_judged("tip cone"));
  EXPECT_FALSE(report.has_judged("bulk cone"));
  EXPECT_FALSE(report.has_judged("apex")) << "none of its entries was judged";
  report.possible = {"tip cone", "bulk apex", "tip"};
  EXPECT_EQ(report.not_visited(), std::vector<std::string>{"bulk apex"});
}

}  // namespace
}  // namespace cleft::tangent_check
