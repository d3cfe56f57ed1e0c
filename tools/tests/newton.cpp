#include "cleft/support/files.hpp"
#include "shell.hpp"

namespace cleft::tools {
namespace {

const std::string kBlock = kScenes + "block.toml --set 'mesh.cells=[16,32]' ";

TEST(NewtonVerb, FindsTheBlockQuadratic) {
  const Outcome o = call("newton " + kBlock + "--order 1.8");
  EXPECT_EQ(o.code, 0) << o.text;
  EXPECT_NE(o.text.find("increments 52, judged "), std::string::npos) << o.text;
}

TEST(NewtonVerb, ReadsTheFolderOfARunAndShowsWhatMisses) {
  const std::string out = fresh("newton_rates");
  ASSERT_EQ(call("newton " + kBlock + "-o " + out).code, 0);
  EXPECT_EQ(call("newton " + out).code, 0);
  const Outcome strict = call("newton " + out + " --order 2.2");
  EXPECT_EQ(strict.code, 1);
  EXPECT_NE(strict.text.find("does not hold: "), std::string::npos) << strict.text;
  EXPECT_NE(strict.text.find("residual/gradient of the correction "), std::string::npos) << "the evidence";
  EXPECT_TRUE(std::regex_search(strict.text, std::regex("slowest: (node|contact point) at \\(0[.0-9]*, 0[.0-9]*\\)")))
      << strict.text;
}

TEST(NewtonVerb, OnAFullDiskTheRunHasFailed) {
  const Outcome o = call("newton " + kBlock + "-o " + fresh("newton_full"), "trap '' XFSZ; ulimit -f 80; ");
  EXPECT_EQ(o.code, 3) << o.text;
  EXPECT_NE(o.text.find("cannot be written"), std::string::npos) << o.text;
}

TEST(NewtonVerb, DoesNotJudgeIterationsThatStopEarly) {
  const std::string out = fresh("newton_early");
  ASSERT_EQ(call("run " + kScenes +
                 "block.toml --set 'mesh.cells=[8,16]' --set solver.residual_tolerance=1e-2 --set "
                 "solver.correction_tolerance=0.1 -o " +
                 out)
                .code,
            0);
  const Outcome o = call("newton " + out + " --all");
  EXPECT_EQ(o.code, 4);
  EXPECT_NE(o.text.find("cannot tell: fewer than half of the increments can be judged"), std::string::npos) << o.text;
}

TEST(NewtonVerb, JudgesWhatThereIsWhereTheSolutionFails) {
  const std::string out = fresh("newton_failed");
  const Outcome o =
      call("newton " + kScenes + "plain.toml --set boundary.top.uy=-0.2 --set solver.min_step=0.05 -o " + out);
  EXPECT_EQ(o.code, 4);
  EXPECT_NE(o.text.find("the run ended at load"), std::string::npos) << o.text;
  EXPECT_NE(o.text.find("attempts that failed"), std::string::npos) << o.text;
  EXPECT_NE(o.text.find("the last of the attempts that failed in the end"), std::string::npos) << o.text;
  const auto newton = read_csv(out + "/newton.csv");
  const auto failed = newton.column("failed"), step = newton.column("step");
  EXPECT_EQ(failed.back(), 1.0);
  EXPECT_EQ(step.back(), read_csv(out + "/history.csv").column("step").size() + 1.0);
}

TEST(NewtonVerb, CallsALinearProblemSound) {
  const Outcome o = call("newton " + kScenes + "homogeneous.toml");
  EXPECT_EQ(o.code, 0) << o.text;
  EXPECT_NE(o.text.find("linear: a step leaves less than 1e-6 of the correction"), std::string::npos) << o.text;
}

TEST(NewtonVerb, RefusesOptionsThatMeanNothing) {
  const std::string out = fresh("newton_options");
  ASSERT_EQ(call("run " + kScenes + "block.toml --set 'mesh.cells=[8,16]' -o " + out).code, 0);
  const Outcome o = call("newton " + out + " --set loading.steps=3");
  EXPECT_EQ(o.code, 2);
  EXPECT_NE(o.text.find("--set and -o go with a scene"), std::string::npos) << o.text;
  EXPECT_EQ(call("newton " + out + " --share 90").code, 2);
}

TEST(NewtonVerb, NamesWhatIsNotThere) {
  const Outcome o = call("newton " + fresh("no_such_run"));
  EXPECT_EQ(o.code, 2);
  EXPECT_NE(o.text.find("there is no such file"), std::string::npos) << o.text;
  const std::string empty = fresh("newton_empty");
  std::filesystem::create_directories(empty);
  EXPECT_EQ(call("newton " + empty).code, 2);
}

}  // namespace
}  // namespace cleft::tools
