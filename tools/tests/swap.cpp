#include "cleft/support/files.hpp"
#include "shell.hpp"

namespace cleft::tools {
namespace {

const std::string kShortBlock = kScenes + "block.toml --load 0.2 --set loading.steps=10 ";

TEST(SwapVerb, ComparesSidesOverMeshesAndWritesTablesAndFigures) {
  const std::string out = fresh("swap");
  const Outcome o = call("swap " + kShortBlock + "--meshes 8x16,16x32 -o " + out);
  EXPECT_EQ(o.code, 0) << o.text;
  for (const char* text : {"16x32", "left", "iterations", "reaction top", "friction_dissipation",
                           "pressure main, 0.1 to 0.9", "not judged", "the check holds"})
    EXPECT_NE(o.text.find(text), std::string::npos) << text << "\n" << o.text;
  for (const char* file : {"values.csv", "differences.csv", "pressure.csv", "swap.json", "pressure_main.svg",
                           "pressure_main.gp", "difference.svg"})
    EXPECT_TRUE(std::filesystem::exists(out + "/" + file)) << file;
  const Outcome again = call("swap " + kShortBlock + "--meshes 8x16,16x32 --tolerance 0 -o " + out);
  EXPECT_EQ(again.code, 1) << again.text;
  EXPECT_NE(again.text.find("16x32 left: was there"), std::string::npos) << "runs are used again\n" << again.text;
}

TEST(SwapVerb, ATurnedSceneHasTheSameSolution) {
  const std::string out = fresh("swap_turn");
  const Outcome o = call("swap " + kShortBlock + "--set 'mesh.cells=[8,16]' --turn 30 --tolerance 0.1 -o " + out);
  EXPECT_EQ(o.code, 0) << o.text;
  EXPECT_NE(o.text.find("turned by 30 degrees"), std::string::npos) << o.text;
  const auto table = read_csv(out + "/differences.csv");
  const auto difference = table.column("difference");
  int compared = 0;
  for (std::size_t k = 0; k < table.rows.size(); ++k) {
    if (table.rows[k][0] != "turned") continue;
    ++compared;
    EXPECT_LT(difference[k], 1e-9) << table.rows[k][1];
  }
  EXPECT_EQ(compared, 10) << "two reactions, six energies, the pressure with and without the ends";
}

TEST(SwapVerb, HoldsTheToleranceAgainstTheFinestMesh) {
  const Outcome o = call("swap " + kShortBlock + "--set 'mesh.cells=[8,16]' --tolerance 0 -o " + fresh("swap_strict"));
  EXPECT_EQ(o.code, 1) << o.text;
  EXPECT_NE(o.text.find("above 0; three meshes show whether it falls"), std::string::npos) << o.text;
}

TEST(SwapVerb, CannotTellWhereARunFailsOrNothingTouches) {
  const Outcome failed = call("swap " + kScenes +
                              "block.toml --set 'mesh.cells=[8,16]' --set solver.max_iterations=1 --set "
                              "solver.min_step=0.01 -o " +
                              fresh("swap_failed"));
  EXPECT_EQ(failed.code, 4) << failed.text;
  EXPECT_NE(failed.text.find("cannot tell: 8x16 left: ended at load"), std::string::npos) << failed.text;
  const Outcome open = call("swap " + kShortBlock + "--set 'mesh.cells=[8,16]' --set boundary.top.ux=0 --set " +
                            "boundary.top.uy=0.001 -o " + fresh("swap_open"));
  EXPECT_EQ(open.code, 4) << open.text;
  EXPECT_NE(open.text.find("nothing is in contact"), std::string::npos) << open.text;
}

TEST(SwapVerb, RefusesABadSceneOrCommandLine) {
  const std::string out = fresh("swap_bad");
  const auto refused = [&](const std::string& arguments, const std::string& message) {
    const Outcome o = call("swap " + arguments + " -o " + out);
    EXPECT_EQ(o.code, 2) << o.text;
    EXPECT_NE(o.text.find(message), std::string::npos) << o.text;
    EXPECT_FALSE(std::filesystem::exists(out)) << arguments;
  };
  refused(kShortBlock + "--crack upper", "--crack: the scene has no crack 'upper'; allowed: main");
  refused(kShortBlock + "--range 0.9,0.1", "--range: 0.9,0.1 is no part of the contact");
  refused(kShortBlock + "--meshes 16x", "--meshes: '16x' is no mesh");
  refused(kShortBlock + "--meshes 16x32,8x16", "the meshes must get finer");
  refused(kShortBlock + "--meshes 2", "mesh.refine");
  refused(kScenes + "plain.toml", "allowed: a scene with a crack");
  refused(kScenes + "closed_crack.toml --turn 30", "cannot be turned");
  EXPECT_EQ(call("swap " + kShortBlock).code, 2) << "no folder";
  EXPECT_EQ(call("swap " + kShortBlock + "--load 0 -o " + out).code, 2);
}

}  // namespace
}  // namespace cleft::tools
