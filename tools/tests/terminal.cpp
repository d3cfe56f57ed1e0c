// What the program prints: the summary of a run, what it warns of and says to look at next, and what a check tells.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "cleft/support/files.hpp"
#include "shell.hpp"

namespace cleft::tools {
namespace {

bool has(const Outcome& outcome, const std::string& part) { return flat(outcome.text).find(part) != std::string::npos; }

std::size_t widest_line(const std::string& text) {
  std::size_t widest = 0;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) widest = std::max(widest, line.size());
  return widest;
}

const std::string kCoarse = "block.toml --set 'mesh.cells=[8,16]' ";

// In a folder whose name fits into a line.
Outcome run_of(const std::string& scene, const std::string& before = "") {
  const std::string folder = std::filesystem::temp_directory_path() / ("cleft" + std::to_string(getpid()));
  std::filesystem::remove_all(folder);
  const Outcome o = call("run " + kScenes + scene + " -o " + folder, before);
  std::filesystem::remove_all(folder);
  return o;
}

TEST(Summary, FitsIntoEightyColumnsAndTellsHowFarHowWellHowLong) {
  const Outcome o = run_of(kCoarse + "--set loading.steps=10");
  ASSERT_EQ(o.code, 0) << o.text;
  EXPECT_LE(widest_line(o.text), 80u) << o.text;
  for (const char* part : {"end done at load 1", "increments 12, iterations ", "worst residual ", ", order ",
                           "overlap 0.072 element sizes at most", "external work ", "imbalance ", "factorise ",
                           "results ", "crack_main.csv", "next `cleft report ", "--set 'mesh.cells=[16,32]'"})
    EXPECT_TRUE(has(o, part)) << part << "\n" << o.text;
  EXPECT_EQ(o.text.find('\x1b'), std::string::npos) << "no colours, no line that is written over";
  EXPECT_FALSE(has(o, "warning"));
}

TEST(Summary, IsColouredOnATerminalOnly) {
  const std::string terminal = "python3 -c 'import pty,sys; pty.spawn(sys.argv[1:])' ";
  const std::string scene = "plain.toml --set 'mesh.cells=[4,8]' --set loading.steps=2", green = "\x1b[32mend";
  EXPECT_NE(run_of(scene, terminal).text.find(green), std::string::npos);
  EXPECT_EQ(run_of(scene, "NO_COLOR=1 " + terminal).text.find(green), std::string::npos);
  EXPECT_EQ(run_of(scene).text.find(green), std::string::npos);
}

TEST(Summary, SaysWhatToLookAtNext) {
  const Outcome grown = run_of("wing_crack.toml --set loading.steps=10");
  EXPECT_TRUE(has(grown, "growth.csv: load, place and turn of each advance")) << grown.text;
  const Outcome cut = run_of("block.toml --set loading.steps=4 --set solver.max_iterations=4");
  EXPECT_TRUE(has(cut, "the column cuts of history.csv")) << cut.text;
  EXPECT_TRUE(has(cut, "`--set loading.steps=8`")) << cut.text;
  const Outcome coarse = run_of("uniaxial.toml --set loading.steps=1 --set boundary.top.uy=0.04");
  EXPECT_TRUE(has(coarse, "% of the energy are not accounted for")) << coarse.text;
  const Outcome failed = run_of("block.toml --set solver.max_iterations=1 --set solver.min_step=0.1");
  EXPECT_TRUE(has(failed, "next the message below says why")) << failed.text;
  EXPECT_FALSE(has(failed, "cleft report")) << "there is nothing to draw";
}

TEST(Summary, WarnsOfWhatTheSolutionShows) {
  EXPECT_FALSE(has(run_of(kCoarse), "warning"));
  const Outcome soft = run_of(kCoarse + "--set crack.main.contact.normal_penalty=1e10");
  EXPECT_TRUE(has(soft, "warning the crack's faces overlap by")) << soft.text;
  EXPECT_LE(widest_line(soft.text), 80u) << soft.text;
}

TEST(Check, TellsMaterialsLoadsAndIncrementsAndThatTheSceneIsSound) {
  const Outcome o = call("check " + kScenes + "block.toml --set 'boundary.top.amplitude=[[0,0],[0.5,1],[1,0]]'");
  EXPECT_EQ(o.code, 0);
  EXPECT_LE(widest_line(o.text), 80u) << o.text;
  for (const char* part : {"hencky, E 1e+10 Pa, nu 0.25", "bottom: ux = 0 m, uy = 0 m",
                           "top: ux = -0.01 m, uy = -0.01 m, times 0 at load 0, 1 at load 0.5, 0 at load 1",
                           "increments 50, outputs at 0.25, 0.5, 0.75, 1", "mind the notes"})
    EXPECT_TRUE(has(o, part)) << part << "\n" << o.text;
  const Outcome plain = call("check " + kScenes + "plain.toml");
  EXPECT_TRUE(plain.text.ends_with("sound                    nothing stands against solving this scene\n"))
      << plain.text;
  EXPECT_FALSE(has(call("check " + kScenes + "block.toml --set loading.steps=0"), "sound"));
}

TEST(Resume, TellsWhichKeysDiffer) {
  const std::string out = fresh("resume_keys"), run = "run " + kScenes + kCoarse + "-o " + out;
  ASSERT_EQ(call(run + " --set loading.steps=4").code, 0);
  const Outcome o =
      call(run + " --set loading.steps=4 --set crack.main.friction=0.4 --set boundary.top.uy=-0.02 --resume");
  EXPECT_EQ(o.code, 2);
  EXPECT_TRUE(
      has(o, "differs in crack.main.friction (0.3 before, 0.4 now), boundary.top.uy (-0.01 before, -0.02 now);"))
      << o.text;
}

TEST(Converge, SaysWhatIsUncertainAboutTheFinestResultAndWhyNothingElseIsKnown) {
  const std::string out = fresh("no_uncertainty"), study = out + ".toml";
  std::ofstream(study) << "scene = \"" << kScenes << "block.toml\"\nset = [\"loading.steps=4\"]\n"
                       << "cells = [[4, 8], [6, 12], [8, 16]]\n[[quantity]]\ncolumn = \"fy_top\"\nload = 0.5\n";
  const Outcome o = call("converge " + study + " -o " + out);
  EXPECT_EQ(o.code, 0) << o.text;
  const auto fits = read_csv(out + "/fits.csv");
  const auto remark = std::ranges::find(fits.header, "remark") - fits.header.begin();
  EXPECT_TRUE(has(o, fits.rows.at(0).at(static_cast<std::size_t>(remark)))) << o.text;
  EXPECT_TRUE(has(o, "limit NOT DETERMINED: 3 meshes do not determine an order")) << o.text;
  EXPECT_TRUE(has(o, "(95 %, grid convergence index, factor 3)")) << o.text;
  EXPECT_TRUE(has(o, "observed orders ")) << o.text;
}

// 0 holds, 1 does not, 4 cannot tell.
TEST(Converge, ExitsByWhatIsKnown) {
  const std::string out = fresh("exit_codes"), study = out + ".toml";
  const auto code = [&](const std::string& cells, const std::string& within) {
    std::ofstream(study) << "scene = \"" << kScenes << "manufactured.toml\"\ncells = " << cells
                         << "\n[[quantity]]\nerror = \"l2\"\norder_within = " << within << "\n";
    return call("converge " + study + " -o " + out);
  };
  const std::string four = "[[4, 4], [8, 8], [16, 16], [32, 32]]";
  EXPECT_EQ(code(four, "[1.5, 2.5]").code, 0);
  const Outcome missed = code(four, "[0.5, 1.0]");
  EXPECT_EQ(missed.code, 1);
  EXPECT_TRUE(has(missed, "does not hold: l2 error: order ")) << missed.text;
  const Outcome three = code("[[4, 4], [8, 8], [16, 16]]", "[1.5, 2.5]");
  EXPECT_EQ(three.code, 4);
  EXPECT_TRUE(has(three, "cannot tell: l2 error: order is not determined: 3 meshes")) << three.text;
}

TEST(Converge, ComparesWithTheFinestMeshWhereNoLimitIsDetermined) {
  const std::string out = fresh("no_limit"), study = out + ".toml";
  std::ofstream(study)
      << "scene = \"" << kScenes << "block.toml\"\nset = [\"loading.steps=4\"]\n"
      << "cells = [[4, 8], [8, 16], [16, 32]]\n[[quantity]]\ncolumn = \"contact_points\"\nload = 0.25\n";
  const Outcome o = call("converge " + study + " -o " + out);
  EXPECT_EQ(o.code, 0) << o.text;
  EXPECT_TRUE(has(o, "limit NOT DETERMINED: ")) << o.text;
  EXPECT_TRUE(has(o, "from finest")) << o.text;
  EXPECT_FALSE(has(o, "rel. error")) << o.text;
}

TEST(Manual, IsMadeOfWhatTheHelpTells) {
  const Outcome o = call("man", "LC_ALL=C ");
  EXPECT_EQ(o.code, 0);
  for (const char* part :
       {".TH CLEFT 1 ", ".SS cleft run", "\\fB\\-o, \\-\\-output\\fR TEXT", "\\fBcrack.growth.tips\\fR"})
    EXPECT_NE(o.text.find(part), std::string::npos) << part;
  std::istringstream lines(o.text);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with('.')) {
      EXPECT_TRUE(line.starts_with(".S") || line.starts_with(".T") || line.starts_with(".B")) << line;
    }
}

}  // namespace
}  // namespace cleft::tools
