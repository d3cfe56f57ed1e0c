#include "shell.hpp"

namespace cleft::tools {
namespace {

TEST(TangentVerb, PassesTheBlockAndSaysWhatItJudged) {
  const Outcome o = call("tangent " + kScenes + "block.toml --set 'mesh.cells=[8,16]'");
  EXPECT_EQ(o.code, 0) << o.text;
  for (const char* text :
       {"states between converged ones", "bulk elastic left", "contact slip", "contact at a mouth", "assembled",
        "crack main, left face, arc length", "force y of node", "lowest order in e 2.00", "below 1.0e-06"})
    EXPECT_NE(o.text.find(text), std::string::npos) << text << "\n" << o.text;
  EXPECT_EQ(o.text.find("not judged"), std::string::npos) << o.text;
}

TEST(TangentVerb, ListsKinksApart) {
  const Outcome o = call("tangent " + kScenes + "rotation.toml");
  EXPECT_EQ(o.code, 0) << o.text;
  EXPECT_NE(o.text.find("not judged"), std::string::npos) << o.text;
  EXPECT_NE(o.text.find("between stick and slip: 80 in all"), std::string::npos)
      << "the rigid turn of two states moves no point off its limit\n"
      << o.text;
}

// The gaps of this scene are nanometres.
TEST(TangentVerb, CannotTellWhereRoundingLeavesTooLittleToJudge) {
  const Outcome o = call("tangent " + kScenes + "through_crack.toml --tolerance 1e-9");
  EXPECT_EQ(o.code, 4) << o.text;
  EXPECT_NE(o.text.find("cannot tell: too little could be judged"), std::string::npos) << o.text;
}

TEST(TangentVerb, CannotTellWithoutTheBranchesThatAreRequired) {
  const std::string block = "tangent " + kScenes + "block.toml --set 'mesh.cells=[8,16]' --require ";
  EXPECT_EQ(call(block + "stick,slip").code, 0);
  const Outcome o = call(block + "'stick,tip cone'");
  EXPECT_EQ(o.code, 4) << o.text;
  EXPECT_NE(o.text.find("required, but no state came to it: tip cone"), std::string::npos) << o.text;
  const Outcome wrong = call(block + "apx");
  EXPECT_EQ(wrong.code, 2);
  EXPECT_NE(wrong.text.find("apx is on no branch; the words of branches are apex, "), std::string::npos) << wrong.text;
}

TEST(TangentVerb, NamesBranchesThatNoStateCameTo) {
  const Outcome o = call("tangent " + kScenes + "manufactured_cut.toml");
  EXPECT_EQ(o.code, 0) << o.text;
  EXPECT_NE(
      o.text.find("branches of this scene that no state came to: contact at a mouth, contact first touch, contact"),
      std::string::npos)
      << o.text;
}

TEST(TangentVerb, SaysWhenTheRunFails) {
  const Outcome o = call("tangent " + kScenes + "block.toml --set solver.max_iterations=1 --set solver.min_step=0.01");
  EXPECT_EQ(o.code, 3);
  EXPECT_NE(o.text.find("the run failed"), std::string::npos) << o.text;
}

TEST(TangentVerb, RefusesABadSceneOrCommandLine) {
  EXPECT_EQ(call("tangent nowhere.toml").code, 2);
  EXPECT_EQ(call("tangent " + kScenes + "plain.toml --tolerance 1e-15").code, 2) << "beyond what differences can tell";
  EXPECT_EQ(call("tangent " + kScenes + "plain.toml --states 0").code, 2);
}

}  // namespace
}  // namespace cleft::tools
