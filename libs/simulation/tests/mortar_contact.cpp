// Mortar contact as scenes ask for it.
#include <cmath>

#include "cleft/problem/build.hpp"
#include "cleft/problem/specification.hpp"
#include "cleft/results/checkpoint.hpp"
#include "cleft/support/files.hpp"
#include "runs.hpp"
#include "scene/tests/faults.hpp"

namespace cleft::simulation {
namespace {

const std::string kPenalty = "contact = { normal_penalty = 2.0e12 }";

problem::Specification with(const std::string& contact, const std::string& more = "") {
  const Folder folder;
  std::string text = kBlock;
  text.replace(text.find(kPenalty), kPenalty.size(), "contact = { " + contact + " }" + more);
  return scene::read_scene(folder.write("scene.toml", text));
}

TEST(MortarContact, IsWhatACrackHasUnlessItAsksForSprings) {
  EXPECT_TRUE(with("").cracks[0].mortar.on);
  EXPECT_TRUE(with("smoothing = 0").cracks[0].mortar.on);
  EXPECT_FALSE(with("normal_penalty = 2.0e12").cracks[0].mortar.on);
  EXPECT_FALSE(with("tangential_penalty = 2.0e12").cracks[0].mortar.on);
}

TEST(MortarContact, IsExactWithWiderHatsWhereItIsNotSmoothed) {
  EXPECT_FALSE(with("method = \"penalty\"").cracks[0].mortar.on);
  const auto smooth = with("method = \"mortar\"").cracks[0].mortar,
             exact = with("method = \"mortar\", smoothing = 0").cracks[0].mortar;
  EXPECT_TRUE(smooth.on);
  EXPECT_EQ(smooth.smoothing, 2.0);
  EXPECT_EQ(smooth.hat_width, 1.0);
  EXPECT_EQ(exact.smoothing, 0.0);
  EXPECT_EQ(exact.hat_width, 2.0);
  EXPECT_EQ(with("method = \"mortar\", smoothing = 0, hat_width = 1.5").cracks[0].mortar.hat_width, 1.5);
}

TEST(MortarContact, ReportsKeysOfTheOtherMethodAndNumbersThatMakeNoSense) {
  for (const Fault& fault : std::vector<Fault>{
           {kPenalty.c_str(), "contact = { method = \"mortar\", normal_penalty = @2.0e12 }",
            "crack[0].contact.normal_penalty", "does not apply to method = \"mortar\"; allowed with penalty"},
           {kPenalty.c_str(), "contact = { normal_penalty = 2.0e12, smoothing = @1.0 }", "crack[0].contact.smoothing",
            "does not apply to method = \"penalty\"; allowed with mortar"},
           {kPenalty.c_str(), "contact = { method = \"penalty\", hat_width = @1.0 }", "crack[0].contact.hat_width",
            "does not apply to method = \"penalty\"; allowed with mortar"},
           {kPenalty.c_str(), "contact = { method = \"mortar\", smoothing = @-1.0 }", "crack[0].contact.smoothing",
            "0 or greater"},
           {kPenalty.c_str(), "contact = { method = \"mortar\", hat_width = @0.0 }", "crack[0].contact.hat_width",
            "positive"}})
    expect_reported(fault, [](const std::string& file) { (void)scene::read_scene(file); });
}

TEST(MortarContact, HasTwoUnknownsAHatOnTheFacesThatAreIntegrated) {
  auto scene = with("method = \"mortar\"");
  const auto one = problem::build_model(scene);
  EXPECT_GT(one.unknowns.multipliers, 2);
  EXPECT_EQ(one.surfaces.first_multiplier, one.unknowns.displacements());
  EXPECT_EQ(one.unknowns.multipliers, static_cast<Index>(one.surfaces.multiplier_space.nodes.size()));
  scene.cracks[0].negative_side = contact::NegativeSide::Both;
  EXPECT_EQ(problem::build_model(scene).unknowns.multipliers, 2 * one.unknowns.multipliers);
  EXPECT_EQ(problem::build_model(with("method = \"penalty\"")).unknowns.multipliers, 0);
}

TEST(MortarContact, ResumesBitForBit) {
  const Folder folder;
  const problem::Specification scene = with("method = \"mortar\"");
  ASSERT_EQ(run(scene, into(folder / "whole")).end, RunResult::End::Done);
  const RunResult result = run_step_by_step(scene, folder / "parts");
  ASSERT_EQ(result.end, RunResult::End::Done) << result.reason;
  for (const char* file : {"history.csv", "crack_main.csv"})
    EXPECT_EQ(read_bytes(folder / "parts" + "/" + file), read_bytes(folder / "whole" + "/" + file)) << file;
}

TEST(MortarContact, ShowsTheTractionsOfItsHatsInTheProfile) {
  const Folder folder;
  ASSERT_EQ(run(with("method = \"mortar\""), into(folder / "run")).end, RunResult::End::Done);
  const auto profile = read_csv(folder / "run" + "/crack_main.csv");
  const auto tn = profile.column("tn"), tt = profile.column("tt");
  int slipping = 0;
  for (std::size_t k = 0; k < tn.size(); ++k) {
    EXPECT_LE(tn[k], 0.0);
    EXPECT_LE(std::fabs(tt[k]), 0.3 * std::fabs(tn[k]) * (1.0 + 1e-9));
    slipping += tn[k] < 0.0;
  }
  EXPECT_GT(slipping, 3);
}

}  // namespace
}  // namespace cleft::simulation
