#include "shell.hpp"

namespace cleft::tools {
namespace {

TEST(TangentVerb, PassesTheBlockAndNamesItsBlocks) {
  const Outcome o = call("tangent " + kScenes + "block.toml --set 'mesh.cells=[8,16]'");
  EXPECT_EQ(o.code, 0) << o.text;
  for (const char* text : {"5 states", "bulk left", "contact slip", "force y of node", "below 1.0e-06"})
    EXPECT_NE(o.text.find(text), std::string::npos) << text << "\n" << o.text;
}

TEST(TangentVerb, FailsAboveTheTolerance) {
  const Outcome o = call("tangent " + kScenes + "plain.toml --states 1 --tolerance 1e-15");
  EXPECT_EQ(o.code, 1);
  EXPECT_NE(o.text.find("NOT below"), std::string::npos) << o.text;
}

TEST(TangentVerb, SaysWhenTheRunFails) {
  const Outcome o = call("tangent " + kScenes + "block.toml --set solver.max_iterations=1 --set solver.min_step=0.01");
  EXPECT_EQ(o.code, 3);
  EXPECT_NE(o.text.find("the run failed"), std::string::npos) << o.text;
  EXPECT_EQ(call("tangent nowhere.toml").code, 2);
}

}  // namespace
}  // namespace cleft::tools
