#include "taylor_test.hpp"

#include <gtest/gtest.h>

#include "cleft/problem/build.hpp"
#include "cleft/scene/read.hpp"
#include "cleft/tangent_check/intermediate_states.hpp"
#include "flow_branch.hpp"

namespace cleft::tangent_check {
namespace {

struct Turned {
  assembly::Model model = problem::build_model(
      scene::read_scene(std::string(CLEFT_SOURCE_DIR) + "/verification/scenes/plain.toml", {"mesh.cells=[4,8]"}));
  assembly::State rest = assembly::state_at_rest(model);
  VecX u = VecX::Zero(model.unknowns.components());
  assembly::Assembler assembler{model};

  Turned() {
    for (Index k = 0; k < model.unknowns.count; ++k)
      u.segment<2>(2 * k) = 0.1 * Vec2(model.mesh.nodes[k].y(), -model.mesh.nodes[k].y());
    EXPECT_FALSE(assembler.assemble(u, rest.history));
  }
  bool test(TaylorTest& out, double tolerance = 1e-6) {
    return test_remainder({model, rest.history, u, 0.5}, tolerance, assembler, out);
  }
};

TEST(Taylor, RemainderOfAnExactTangentIsOfSecondOrder) {
  Turned body;
  TaylorTest out;
  EXPECT_TRUE(body.test(out));
  EXPECT_EQ(out.states, 1);
  EXPECT_NEAR(out.order, 2.0, 0.02);
  EXPECT_LT(out.first_order, 1e-8);
}

TEST(Taylor, OneWrongEntryLeavesAPartOfFirstOrder) {
  Turned body;
  double& entry = body.assembler.matrix().values()[body.assembler.matrix().values().size() / 2];
  entry += 0.01 * std::fabs(body.assembler.matrix().entry(20, 20));
  TaylorTest out;
  EXPECT_FALSE(body.test(out));
  EXPECT_NEAR(out.order, 1.0, 0.1);
  EXPECT_GT(out.first_order, 1e-5);
  EXPECT_EQ(out.load, 0.5);
  EXPECT_TRUE(out.force.find("of node") != std::string::npos) << out.force;
}

// Makes the rows of everything that flows wrong by a hundredth: the tangent of another law of flow.
void corrupt_flow(const CheckedState& at, assembly::Assembler& assembler) {
  std::vector<Index> flowing;
  const auto flow = flow_branches(at.model, at.history, at.u);
  add_flow_kinks(at.model, flow, std::vector<FlowBranch>(flow.size(), FlowBranch::Elastic), flowing);
  auto& matrix = assembler.matrix();
  const auto rows = matrix.scalar_rows();
  for (std::size_t k = 0; k < rows.size(); ++k)
    if (std::ranges::find(flowing, rows[k] / 2) != flowing.end()) matrix.values()[k] *= 1.01;
}

// Steps are short: points that flow leave their branch within the first sizes; the sound rows around them do not.
TEST(Taylor, FindsAWrongTangentOfFlowByItself) {
  for (const char* kinematics : {"small", "finite"}) {
    const auto scene = scene::read_scene(std::string(CLEFT_SOURCE_DIR) + "/verification/scenes/block_yield_small.toml",
                                         {"mesh.cells=[8,16]", "loading.steps=1000", "loading.outputs=[1.0]",
                                          std::string("formulation.kinematics=") + kinematics});
    growth::Evolution body(scene, problem::build_model(scene));
    TaylorTest sound, faulty;
    int flowing = 0;
    EXPECT_FALSE(visit_increments(body, [&](const IntermediateState& state) {
      const CheckedState at{state.model, state.before.history, state.displacement, state.load};
      assembly::Assembler assembler(state.model);
      EXPECT_FALSE(assembler.assemble(at.u, at.history));
      EXPECT_TRUE(test_remainder(at, 1e-6, assembler, sound)) << state.load;
      const auto flow = flow_branches(at.model, at.history, at.u);
      if (std::ranges::all_of(flow, [](FlowBranch b) { return b == FlowBranch::Elastic; })) return true;
      ++flowing;
      EXPECT_FALSE(assembler.assemble(at.u, at.history));
      corrupt_flow(at, assembler);
      EXPECT_FALSE(test_remainder(at, 1e-6, assembler, faulty)) << kinematics << " at load " << state.load;
      return flowing < 20;
    }));
    EXPECT_EQ(flowing, 20);
    EXPECT_EQ(faulty.states, flowing);
    EXPECT_EQ(sound.unclear, 0);
    EXPECT_GT(sound.share, 0.9);
    EXPECT_GT(faulty.first_order, 1e-4);
  }
}

TEST(Taylor, HasNoAnswerWhereTooFewRowsAreJudged) {
  Turned body;
  TaylorTest out;
  EXPECT_TRUE(body.test(out, 1e-15));
  EXPECT_EQ(out.states, 0);
  EXPECT_EQ(out.unclear, 1);
}

TEST(Taylor, ATangentThatIsNotANumberIsWrong) {
  Turned body;
  body.assembler.matrix().values()[0] = std::nan("");
  TaylorTest out;
  EXPECT_FALSE(body.test(out));
  EXPECT_FALSE(out.first_order < 1e300);
}

}  // namespace
}  // namespace cleft::tangent_check
