#include "cleft/verify/tangent.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "cleft/scene/problem.hpp"
#include "cleft/scene/read.hpp"
#include "colouring.hpp"

namespace cleft::verify {
namespace {

struct SlidingBlock {
  assembly::Model model;
  assembly::LoadStepper stepper;
  explicit SlidingBlock(const std::string& side = "left")
      : SlidingBlock(scene::read_scene(std::string(CLEFT_SOURCE_DIR) + "/verification/scenes/block.toml",
                                       {"mesh.cells=[8,16]", "crack.main.negative_side=" + side})) {}
  explicit SlidingBlock(const scene::Scene& scene)
      : model(scene::build_model(scene)), stepper(model, scene::step_controls(scene)) {
    while (stepper.state().load < 0.5) EXPECT_EQ(stepper.advance().index(), 0u);
  }
  VecX ahead(double part) const {
    const auto& s = stepper.state();
    return s.displacement + part * (s.displacement - s.previous_displacement);
  }
};

TEST(CheckTangent, ReportsBulkBySideAndContactByStatus) {
  for (const char* side : {"left", "right", "both"}) {
    const SlidingBlock block(side);
    TangentReport report;
    check_tangent(block.model, block.stepper.state(), block.ahead(0.37), 1e-6, report);
    EXPECT_EQ(report.states, 1);
    EXPECT_LT(report.worst(), 1e-7);
    for (const char* name : {"bulk", "bulk left", "bulk right", "contact slip"})
      EXPECT_GT(report.blocks[name].entries, 50) << name;
    EXPECT_EQ(report.inconsistent.entries, 0);
  }
}

TEST(CheckTangent, KnowsTheKinkOnWhichSlidingPointsSitOnceTheirAnchorsHaveMoved) {
  const SlidingBlock block;
  TangentReport report;
  check_tangent(block.model, block.stepper.state(), block.ahead(0.0), 1e-6, report);
  EXPECT_GT(report.kink_points["status changes"], 10);
  EXPECT_GT(report.kinks, 100);
  EXPECT_LT(report.worst(), 1e-6) << "kinks are left out";
}

TEST(CheckTangent, NamesComponents) {
  const SlidingBlock block;
  EXPECT_EQ(describe_component(block.model, 1), "y of node 0 at (0, 0)");
  EXPECT_NE(describe_component(block.model, 2 * block.model.unknowns.nodes).find("displacement of the other side"),
            std::string::npos);
}

TEST(ColourColumns, PutsNoTwoColumnsWithACommonRowIntoAGroup) {
  const SlidingBlock block;
  assembly::Assembler assembler(block.model);
  const auto groups = colour_columns(assembler.matrix());
  std::vector<int> seen(assembler.matrix().size(), 0);
  for (const auto& group : groups) {
    std::vector<int> rows(assembler.matrix().size(), 0);
    for (const Index j : group) {
      ++seen[j];
      for (const Index i : assembler.matrix().block_rows(j)) EXPECT_EQ(rows[i]++, 0);
    }
  }
  EXPECT_TRUE(std::all_of(seen.begin(), seen.end(), [](int n) { return n == 1; })) << "every column once";
  EXPECT_LT(groups.size(), 100u);
}

}  // namespace
}  // namespace cleft::verify
