#include <algorithm>
#include <vector>

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
  const Outcome o = call("tangent " + kScenes + "manufactured_cut.toml --require slip,stick");
  EXPECT_EQ(o.code, 4) << o.text;
  EXPECT_NE(o.text.find("required, but no state came to it: stick"), std::string::npos) << o.text;
  const Outcome wrong = call(block + "apx");
  EXPECT_EQ(wrong.code, 2);
  EXPECT_NE(wrong.text.find("apx is on no branch; the words of branches are apex, "), std::string::npos) << wrong.text;
}

TEST(TangentVerb, RefusesToWaitForBranchesThatTheSceneHasNot) {
  for (const char* words : {"apex", "'stick,tip cone'"}) {
    const Outcome o = call("tangent " + kScenes + "block.toml --set 'mesh.cells=[8,16]' --require " + words);
    EXPECT_EQ(o.code, 2) << o.text;
    EXPECT_NE(flat(o.text).find("its branches are bulk elastic, contact at a mouth,"), std::string::npos) << o.text;
  }
}

// Turned by 180 degrees while its sides are stretched and shortened, in one increment: inverted in between.
TEST(TangentVerb, GoesOnBehindAStateWithoutForces) {
  std::string turned = "tangent " + kScenes + "homogeneous.toml --set material.model=neo-hookean --set loading.steps=1";
  for (const char* side : {"bottom", "top", "left", "right"})
    turned += std::string(" --set 'boundary.") + side + ".affine=[[-4.0,0.0],[0.0,-1.5]]'";
  const Outcome o = call(turned);
  EXPECT_EQ(o.code, 4) << o.text;
  for (const char* text :
       {"load 0.37: the whole body: this state has no forces", "remainder of the residual: none of 1"})
    EXPECT_NE(o.text.find(text), std::string::npos) << text << "\n" << o.text;
  EXPECT_EQ(o.text.find("the run failed"), std::string::npos) << o.text;
}

TEST(TangentVerb, NamesBranchesThatNoStateCameTo) {
  const Outcome o = call("tangent " + kScenes + "manufactured_cut.toml");
  EXPECT_EQ(o.code, 0) << o.text;
  EXPECT_NE(
      o.text.find("branches of this scene that no state came to: contact at a mouth, contact first touch, contact"),
      std::string::npos)
      << o.text;
}

TEST(TangentVerb, CannotTellWhereTheRunFails) {
  const Outcome o = call("tangent " + kScenes + "block.toml --set solver.max_iterations=1 --set solver.min_step=0.01");
  EXPECT_EQ(o.code, 4);
  EXPECT_NE(o.text.find("the run failed: "), std::string::npos) << o.text;
  EXPECT_NE(o.text.find("cannot tell: "), std::string::npos) << o.text;
}

TEST(TangentVerb, RefusesABadSceneOrCommandLine) {
  EXPECT_EQ(call("tangent nowhere.toml").code, 2);
  EXPECT_EQ(call("tangent " + kScenes + "plain.toml --tolerance 1e-15").code, 2) << "beyond what differences can tell";
  EXPECT_EQ(call("tangent " + kScenes + "plain.toml --states 0").code, 2);
}

// Every scene of verification/scenes, on coarse meshes.
struct SoundScene {
  const char* name;
  const char* overrides = "";
  const char* why_not = "";  // it cannot be told
};
const std::vector<SoundScene> kSound{
    SoundScene{"block", "--set mesh.cells=[8,16]"},
    SoundScene{"block_small_scale_yield", "--set mesh.cells=[8,16]"},
    SoundScene{"block_yield_finite", "--set mesh.cells=[8,16]"},
    SoundScene{"block_yield_small", "--set mesh.cells=[8,16]"},
    SoundScene{"closed_crack", "--set mesh.cells=[20,20]"},
    SoundScene{"drag", "--set mesh.cells=[20,5]"},
    SoundScene{"footing", "--set mesh.cells=[16,8]"},
    SoundScene{"homogeneous"},
    SoundScene{"manufactured"},
    SoundScene{"manufactured_cut"},
    SoundScene{"plain", "--set mesh.cells=[8,16]"},
    SoundScene{"plate_crack", "--set mesh.cells=[26,38]"},
    SoundScene{"punch", "--set mesh.cells=[16,8]"},
    SoundScene{"ring", "--set mesh.size=0.2"},
    SoundScene{"rotation"},
    SoundScene{"s_crack", "--set loading.steps=50"},
    SoundScene{"slanted_crack", "--set mesh.cells=[28,28]"},
    SoundScene{"slope", "--set mesh.size=1.5"},
    SoundScene{"squeezed"},
    SoundScene{"straight_wings", "--set mesh.size=24.0 --set mesh.crack_size=0.12 --set mesh.tip_size=0.06"},
    SoundScene{"through_crack", "", "of 240 points that press"},
    SoundScene{"uniaxial"},
    SoundScene{"wing_crack"}};
class SoundTangent : public testing::TestWithParam<SoundScene> {};

TEST_P(SoundTangent, IsNoFalseAlarm) {
  const auto& [name, overrides, why_not] = GetParam();
  const Outcome o = call("tangent " + kScenes + name + ".toml --states 1 " + overrides);
  EXPECT_EQ(o.code, *why_not ? 4 : 0) << o.text;
  EXPECT_NE(o.text.find(why_not), std::string::npos) << o.text;
}

INSTANTIATE_TEST_SUITE_P(Scenes, SoundTangent, testing::ValuesIn(kSound),
                         [](const auto& s) { return std::string(s.param.name); });

TEST(SoundTangents, AreOfAllScenes) {
  for (const auto& file : std::filesystem::directory_iterator(kScenes))
    EXPECT_TRUE(std::ranges::any_of(kSound, [&](const auto& s) { return file.path().stem() == s.name; }))
        << file.path();
}

}  // namespace
}  // namespace cleft::tools
