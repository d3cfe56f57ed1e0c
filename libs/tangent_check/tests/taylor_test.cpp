#include "taylor_test.hpp"

#include <gtest/gtest.h>

#include "cleft/problem/build.hpp"
#include "cleft/scene/read.hpp"

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
  bool test(TaylorTest& out) { return test_remainder({model, rest.history, u, 0.5}, 1e-6, assembler, out); }
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

}  // namespace
}  // namespace cleft::tangent_check
