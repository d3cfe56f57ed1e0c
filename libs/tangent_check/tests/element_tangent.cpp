// Pieces of the body by the branch of their law.
#include "element_tangent.hpp"

#include <gtest/gtest.h>

#include "chosen_states.hpp"
#include "cleft/problem/build.hpp"
#include "cleft/scene/read.hpp"

namespace cleft::tangent_check {
namespace {

problem::Specification specification(const std::string& scene, const std::vector<std::string>& overrides) {
  return scene::read_scene(std::string(CLEFT_SOURCE_DIR) + "/verification/scenes/" + scene + ".toml", overrides);
}

TangentReport along(const std::string& scene, const std::vector<std::string>& overrides, int states = 2) {
  const auto read = specification(scene, overrides);
  growth::Evolution body(read, problem::build_model(read));
  TangentReport report;
  see_chosen_states(body, states, [&](const IntermediateState& b) {
    EXPECT_FALSE(check_tangent(b.model, b.before.history, b.displacement, b.load, 1e-6, report));
  });
  return report;
}

long pieces(const TangentReport& report, const std::string& kind) {
  long out = 0;
  for (const auto& [name, block] : report.blocks)
    if (name.starts_with(kind)) out += block.pieces;
  return out;
}

TEST(ElementTangents, KnowHowLongTheIncrementTakes) {
  for (const char* kinematics : {"small", "finite"}) {
    const auto report = along("squeezed", {"formulation.f_bar=false", "material.viscosity=100", "loading.steps=10",
                                           std::string("formulation.kinematics=") + kinematics});
    EXPECT_TRUE(report.visited("bulk viscous cone")) << kinematics;
    EXPECT_FALSE(report.blocks.contains("bulk cone")) << kinematics << ": that law does not last";
    EXPECT_LT(report.worst(), 1e-7) << kinematics;
  }
}

TEST(ElementTangents, OfPatchesHaveTheBranchesOfBothCells) {
  const auto report = along("squeezed", {}, 10);
  EXPECT_TRUE(report.visited("patch cone"));
  EXPECT_TRUE(report.visited("patch elastic"));
  EXPECT_EQ(pieces(report, "bulk"), 0);
  EXPECT_EQ(pieces(report, "patch"), 10 * 16);
}

TEST(ElementTangents, TakeApartTipsAndTies) {
  const std::vector<std::string> overrides{"mesh.cells=[8,16]", "formulation.tip_enrichment=0.004",
                                           "crack.main.points=[[0.0,0.0201],[0.0349,0.0551]]"};
  const auto model = problem::build_model(specification("block_yield_small", overrides));
  ASSERT_FALSE(model.tip_points.empty());
  ASSERT_FALSE(model.ties.empty());
  const auto report = along("block_yield_small", overrides);
  EXPECT_EQ(pieces(report, "tip"), 2 * static_cast<long>(model.tip_points.size()));
  EXPECT_EQ(pieces(report, "ghost tie"), 2 * static_cast<long>(model.ties.size()));
  EXPECT_EQ(pieces(report, "bulk"), 2 * static_cast<long>(model.cells.size()));
  EXPECT_LT(report.worst(), 1e-6);
}

// A uniform compression at which a square just yields, to the last bit, and states around it.
class AtYield : public testing::Test {
 protected:
  VecX pressed(double strain) const {
    VecX u = VecX::Zero(model_.unknowns.components());
    for (Index k = 0; k < model_.unknowns.count; ++k) u[2 * k + 1] = -strain * model_.mesh.nodes[k].y();
    return u;
  }
  bool flows(double strain) const {
    const auto branches = flow_branches(model_, rest_.history, pressed(strain));
    return std::ranges::any_of(branches, [](FlowBranch b) { return b != FlowBranch::Elastic; });
  }
  double yield() const {
    double below = 0.0, above = 0.1;
    for (int k = 0; k < 60; ++k) (flows(0.5 * (below + above)) ? above : below) = 0.5 * (below + above);
    return above;
  }
  TangentReport at(double strain) const {
    TangentReport report;
    EXPECT_FALSE(check_tangent(model_, rest_.history, pressed(strain), 0.5, 1e-6, report));
    return report;
  }

  assembly::Model model_ = problem::build_model(specification("squeezed", {"formulation.f_bar=false"}));
  assembly::State rest_ = assembly::state_at_rest(model_);
};

TEST_F(AtYield, StepsThatStayOnTheBranchJudgeEveryEntry) {
  const double strain = yield();
  ASSERT_GT(strain, 1e-3);
  for (const double beside : {-1e-5, 1e-5}) {
    const auto report = at(strain * (1.0 + beside));
    EXPECT_TRUE(report.kinks.empty()) << beside;
    EXPECT_EQ(report.blocks.at(beside < 0.0 ? "bulk elastic" : "bulk cone").left_out, 0) << beside;
    EXPECT_LT(report.worst(), 1e-6) << beside;
  }
}

TEST_F(AtYield, PointsOnTheKinkAreListed) {
  const auto report = at(yield());
  EXPECT_LT(report.worst(), 1e-6);
  ASSERT_FALSE(report.kinks.empty());
  for (const auto& kink : report.kinks)
    EXPECT_TRUE(kink.reason == "between cone and elastic" || kink.reason == "between elastic and cone") << kink.reason;
  EXPECT_FALSE(report.gaps().empty());
}

}  // namespace
}  // namespace cleft::tangent_check
