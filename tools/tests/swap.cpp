#include <fmt/format.h>

#include "cleft/support/files.hpp"
#include "shell.hpp"

namespace cleft::tools {
namespace {

const std::string kShortBlock = kScenes + "block.toml --load 0.2 --set loading.steps=10 ";
const std::string kCoarseBlock = kShortBlock + "--set 'mesh.cells=[8,16]' ";

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

TEST(SwapVerb, RunsAgainWhatWasDamaged) {
  const std::string out = fresh("swap_damaged"), check = "swap " + kCoarseBlock + "--tolerance 0.1 -o " + out;
  ASSERT_EQ(call(check).code, 0);
  const std::string differences = read_bytes(out + "/differences.csv");
  std::string history;
  for (const auto& entry : std::filesystem::directory_iterator(out + "/runs"))
    if (entry.path().filename().string().starts_with("8x16_left_")) history = entry.path() / "history.csv";
  const std::string whole = read_bytes(history);
  std::string damaged = whole;
  char& digit = damaged.at(damaged.find_last_of("123456789"));
  digit = digit == '1' ? '2' : '1';
  write_atomically(history, damaged);
  const Outcome again = call(check);
  EXPECT_EQ(again.code, 0) << again.text;
  EXPECT_EQ(again.text.find("8x16 left: was there"), std::string::npos) << again.text;
  EXPECT_NE(again.text.find("8x16 right: was there"), std::string::npos) << again.text;
  EXPECT_EQ(read_bytes(history), whole);
  EXPECT_EQ(read_bytes(out + "/differences.csv"), differences);
}

TEST(SwapVerb, ResultsThatDoNotFitOnTheDiskAreAFailure) {
  const std::string out = fresh("swap_full");
  ASSERT_EQ(call("swap " + kCoarseBlock + "--tolerance 0.1 -o " + out).code, 0);
  std::filesystem::create_symlink("/dev/full", out + "/values.csv.part");
  const Outcome o = call("swap " + kCoarseBlock + "--tolerance 0.1 -o " + out);
  EXPECT_EQ(o.code, 3) << o.text;
  EXPECT_NE(o.text.find("values.csv: cannot be written: No space left"), std::string::npos) << o.text;
}

// The turned mesh is one of Gmsh, beside the results and not beside the scene.
TEST(SwapVerb, TakesMeshesOfGmshInsteadOfTheScenesMesh) {
  const std::string out = fresh("swap_mesh");
  ASSERT_EQ(call("swap " + kCoarseBlock + "--turn 360 --tolerance 0.1 -o " + out + "/scene").code, 0);
  const Outcome o =
      call("swap " + kShortBlock + "--tolerance 0.1 --meshes scene/turned.msh -o again", "cd " + out + "; ");
  EXPECT_EQ(o.code, 0) << o.text;
  EXPECT_TRUE(std::filesystem::exists(out + "/again/swap.json"));
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

TEST(SwapVerb, OnOneMeshAGrossDifferenceIsAMissAndALesserOneCannotBeTold) {
  const std::string out = fresh("swap_strict"), check = "swap " + kCoarseBlock + "-o " + out + " --tolerance ";
  const Outcome gross = call(check + "0");
  EXPECT_EQ(gross.code, 1) << gross.text;
  EXPECT_NE(gross.text.find("above 10 times 0"), std::string::npos) << gross.text;
  const auto table = read_csv(out + "/differences.csv");
  const auto difference = table.column("difference");
  double largest = 0.0;
  for (std::size_t k = 0; k < difference.size(); ++k)
    if (table.rows[k][6] == "does not hold") largest = std::max(largest, difference[k]);
  const Outcome lesser = call(check + fmt::format("{}", 0.5 * largest));
  EXPECT_EQ(lesser.code, 4) << lesser.text;
  EXPECT_NE(lesser.text.find("; 4 meshes or more may show that it falls"), std::string::npos) << lesser.text;
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
  refused(kShortBlock + "--meshes none.msh", "none.msh; allowed: meshes of Gmsh, relative to the working directory");
  refused(kShortBlock + "--meshes 16x32,8x16", "the meshes must get finer");
  refused(kShortBlock + "--meshes 2", "mesh.refine");
  refused(kScenes + "plain.toml", "allowed: a scene with a crack");
  refused(kScenes + "closed_crack.toml --turn 30", "cannot be turned");
  EXPECT_EQ(call("swap " + kShortBlock).code, 2) << "no folder";
  EXPECT_EQ(call("swap " + kShortBlock + "--load 0 -o " + out).code, 2);
}

}  // namespace
}  // namespace cleft::tools
