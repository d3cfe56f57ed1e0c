// Runs of studies: kept, damaged, failed, timed, over any key.
#include <cmath>
#include <nlohmann/json.hpp>

#include "cleft/scene/json.hpp"
#include "cleft/support/files.hpp"
#include "fresh_study.hpp"
#include "shell.hpp"

namespace cleft::tools {
namespace {

const std::string kLoad = "[[quantity]]\ncolumn = \"fy_top\"\nload = 0.2\n";

// The table with another leading digit in one column of its last row, and of the same length.
std::string with_another_digit(std::string text, const std::string& column) {
  const auto comma_after = [&](std::size_t from) { return text.find(',', from) + 1; };
  std::size_t names = 0, at = text.find_last_of('\n', text.size() - 2) + 1;
  for (; text.compare(names, column.size() + 1, column + ",") != 0; names = comma_after(names)) at = comma_after(at);
  char& digit = text[text.find_first_of("123456789", at)];
  digit = digit == '1' ? '2' : '1';
  return text;
}

TEST(StudyRuns, RunsOnlyWhatChanged) {
  const std::string text = block("cells = [[4, 8], [8, 16]]\n[[quantity]]\ncolumn = \"fy_top\"\nload = 0.2\n");
  const Fresh first("kept", text);
  for (const auto& run : first.run().runs) EXPECT_FALSE(run.reused);
  const StudyResult again = first.run();
  for (const auto& run : again.runs) EXPECT_TRUE(run.reused);
  std::ofstream(first.file) << block(
      "cells = [[4, 8], [8, 16], [10, 20]]\n[[quantity]]\ncolumn = \"fx_top\"\nload = 0.2\n");
  const StudyResult more = first.run();
  EXPECT_TRUE(more.runs[0].reused && more.runs[1].reused);
  EXPECT_FALSE(more.runs[2].reused);
  for (const char* file : {"/run.json", "/study_seal"})  // as a run that was killed leaves it
    std::filesystem::remove(more.runs[1].folder + file);
  const StudyResult resumed = first.run();
  EXPECT_TRUE(resumed.runs[1].phases.empty()) << "of the last part only";
  EXPECT_FALSE(resumed.runs[1].reused);
  EXPECT_EQ(resumed.runs[1].value, more.runs[1].value);
}

// Whatever of a kept run is not as it was left: cut off, garbage, one digit of what is read, gone.
TEST(StudyRuns, ADamagedRunIsRunAgain) {
  const Fresh s("damaged", block("cells = [[4, 8], [8, 16]]\n" + kLoad));
  const StudyResult first = s.run();
  const std::string folder = first.runs[1].folder;
  const auto text = read_bytes(folder + "/history.csv");
  const std::pair<const char*, std::string> damages[] = {{"/history.csv", text.substr(0, text.size() / 2)},
                                                         {"/history.csv", with_another_digit(text, "fy_top")},
                                                         {"/run.json", "{ \"end\": \"done\", "},
                                                         {"/crack_main.csv", ""},
                                                         {"/timings.json", "[]"}};
  for (const auto& [file, bytes] : damages) {
    std::ofstream(folder + file) << bytes;
    const StudyResult again = s.run();
    EXPECT_TRUE(again.failed.empty()) << file << ": " << again.failed[0];
    EXPECT_TRUE(again.runs[0].reused) << file;
    EXPECT_FALSE(again.runs[1].reused) << file;
    EXPECT_EQ(again.runs[1].value, first.runs[1].value) << file;
    EXPECT_TRUE(s.run().runs[1].reused) << file;
  }
  std::ofstream(folder + "/checkpoint") << "no checkpoint";  // what a run cannot go on from
  for (const char* file : {"/history.csv", "/study_seal"}) std::filesystem::remove(folder + file);
  EXPECT_EQ(s.run().runs[1].value, first.runs[1].value);
}

TEST(StudyRuns, EndAtTheLastLoadThatIsAskedFor) {
  const Fresh s("last_load", block("cells = [[4, 8], [8, 16]]\n" + kLoad));
  for (const auto& run : s.run().runs) {
    const auto loads = read_csv(run.folder + "/history.csv").column("load");
    EXPECT_EQ(loads.back(), 0.2) << "of 1";
    EXPECT_EQ(nlohmann::json::parse(read_bytes(run.folder + "/run.json")).at("end"), "done");
  }
}

// One increment of two iterations at most fails at once; what the others have is fitted all the same.
TEST(StudyRuns, AFailedRunIsToldAndTheOthersAreFitted) {
  const Fresh s("failed", block("cells = [[4, 8], [8, 16], [16, 32], [32, 64]]\n"
                                "[[sequence]]\nkey = \"solver.max_iterations\"\nvalues = [12, 12, 12, 1]\n" +
                                kLoad));
  const StudyResult r = s.run();
  ASSERT_EQ(r.failed.size(), 1u);
  EXPECT_EQ(r.failed[0].find("32x64, max_iterations=1: exit code 3: failed at load 0: the iteration did not converge"),
            0u)
      << r.failed[0];
  ASSERT_EQ(r.series.size(), 1u);
  EXPECT_EQ(r.series[0].runs, (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_FALSE(r.series[0].fit.observed_order.empty());
  const auto table = read_csv(s.directory + "/runs.csv");
  EXPECT_EQ(table.rows.size(), 4u);
  EXPECT_TRUE(std::isnan(table.column("fy_top at 0.2")[3]));
  const Outcome told = call("converge " + s.file + " -o " + s.directory);
  EXPECT_EQ(told.code, 3);
  EXPECT_NE(flat(told.text).find("failed: " + s.file + ": 32x64"), std::string::npos) << told.text;
  EXPECT_NE(told.text.find("observed orders"), std::string::npos) << told.text;
}

TEST(StudyRuns, AFailedRunLeavesAMissAMissAndNoCheckHeld) {
  const std::string text = "scene = \"" + kVerification +
                           "scenes/manufactured.toml\"\ncells = [[4, 4], [8, 8], [16, 16], [32, 32], [36, 36]]\n"
                           "[[sequence]]\nkey = \"solver.max_iterations\"\nvalues = [12, 12, 12, 12, 1]\n"
                           "[[quantity]]\nerror = \"l2\"\n";
  const Fresh s("failed_check", text);
  const std::pair<const char*, int> codes[] = {
      {"", 3}, {"order_within = [1.5, 2.5]\n", 4}, {"order_within = [4, 5]\n", 1}, {"order_within = [1, 2]\n", 4}};
  for (const auto& [check, code] : codes) {
    std::ofstream(s.file) << text << check;
    const Outcome told = call("converge " + s.file + " -o " + s.directory);
    EXPECT_EQ(told.code, code) << check << told.text;
    EXPECT_NE(flat(told.text).find("failed: " + s.file + ": 36x36"), std::string::npos) << told.text;
  }
}

// A run that reached its end is not called failed where a column of its history is not a number.
TEST(StudyRuns, TellAMissingValueFromAFailedRun) {
  const Fresh s("no_value", block("cells = [[4, 8], [8, 16], [16, 32]]\n" + kLoad));
  const std::string folder = s.run().runs[1].folder, file = folder + "/history.csv";
  const std::string before = read_bytes(file), seal = read_bytes(folder + "/study_seal");
  const auto history = read_csv(file);
  const auto at = std::ranges::find(history.header, "fy_top") - history.header.begin();
  const std::string cell = history.rows.back()[static_cast<std::size_t>(at)];
  const std::string after = std::string(before).replace(before.rfind(cell), cell.size(), "nan");
  const std::string hash = scene::hash_of(before);
  std::ofstream(file) << after;
  std::ofstream(folder + "/study_seal") << std::string(seal).replace(seal.find(hash), hash.size(),
                                                                     scene::hash_of(after));
  const Outcome told = call("converge " + s.file + " -o " + s.directory);
  EXPECT_EQ(told.code, 0) << told.text;
  EXPECT_NE(told.text.find("- no value\n"), std::string::npos) << told.text;
  EXPECT_EQ(told.text.find("failed"), std::string::npos) << told.text;
}

// Nothing moves up to the first of the two loads, so that one iteration will do.
TEST(StudyRuns, AFailedRunHasTheLoadsThatItReached) {
  const Fresh s("reached", "scene = \"" + kVerification +
                               "scenes/block.toml\"\ncells = [[4, 8], [8, 16]]\n"
                               "set = [\"boundary.top.amplitude=[[0,0],[0.1,0],[1,1]]\", \"loading.steps=10\", "
                               "\"solver.max_iterations=1\"]\n"
                               "[[quantity]]\ncolumn = \"fy_top\"\nload = 0.1\n[[quantity]]\ncolumn = \"fy_top\"\n");
  const StudyResult r = s.run();
  ASSERT_EQ(r.failed.size(), 2u);
  EXPECT_NE(r.failed[0].find("failed at load 0.1: "), std::string::npos) << r.failed[0];
  EXPECT_EQ(r.series[0].runs.size(), 2u);
  EXPECT_TRUE(r.series[1].runs.empty());
  EXPECT_TRUE(r.costs.empty());
}

TEST(StudyRuns, TimingsAreRepeatedAndTheMedianCounts) {
  const Fresh s("timings", block("cells = [[4, 8], [8, 16]]\n" + kLoad));
  EXPECT_EQ(s.run().runs[0].timings, 1);
  StudyOptions options = s.options();
  options.repeats = 3;
  options.jobs = 1;
  const StudyResult r = convergence::run_study(scene::read_study(s.file), options);
  for (const auto& run : r.runs) {
    EXPECT_TRUE(run.reused);
    EXPECT_EQ(run.jobs, 1);
    EXPECT_EQ(run.timings, 3) << "the one beside another run does not count";
    std::vector<double> seconds;
    for (const auto& each : nlohmann::json::parse(read_bytes(run.folder + "/timings.json")))
      if (each.at("jobs") == 1) seconds.push_back(each.at("seconds"));
    std::ranges::sort(seconds);
    ASSERT_EQ(seconds.size(), 3u);
    EXPECT_EQ(run.seconds, seconds[1]);
    EXPECT_EQ(run.seconds_spread, seconds[2] - seconds[0]);
    EXPECT_FALSE(std::filesystem::exists(run.folder + "_again"));
  }
  const auto table = read_csv(s.directory + "/study.csv");
  EXPECT_EQ(table.column("jobs")[0], 1.0);
  EXPECT_EQ(table.column("timings")[0], 3.0);
}

// All forces scale with the stiffness of the body, that of the springs included; no mesh varies.
TEST(StudyRuns, FollowAnyKey) {
  const Fresh s("key", block("[[sequence]]\nkey = \"material.young\"\nvalues = [8e9, 4e9, 2e9, 1e9]\n"
                             "h = \"value\"\n" +
                             kLoad));
  const StudyResult r = s.run();
  ASSERT_TRUE(r.failed.empty()) << r.failed[0];
  EXPECT_EQ(r.runs[3].h, 1e9);
  ASSERT_EQ(r.series[0].fit.observed_order.size(), 2u);
  for (const double order : r.series[0].fit.observed_order) EXPECT_NEAR(order, 1.0, 1e-6);
  EXPECT_EQ(r.costs[0].over, "1/h");
  EXPECT_NE(read_bytes(s.directory + "/convergence.svg").find("material.young"), std::string::npos);
}

TEST(StudyRuns, CombinationsNeedNoSequence) {
  const Fresh s("combinations", block("[[sweep]]\nkey = \"crack.main.friction\"\nvalues = [0.3, 0.6]\n"
                                      "[[sweep]]\nkey = \"mesh.cells\"\nvalues = [[4, 8], [8, 16]]\n" +
                                      kLoad));
  const Outcome told = call("converge " + s.file + " -o " + s.directory);
  EXPECT_EQ(told.code, 0) << told.text;
  EXPECT_NE(told.text.find("friction=0.3, cells=[4, 8]"), std::string::npos) << told.text;
  EXPECT_EQ(told.text.find("NOT DETERMINED"), std::string::npos) << told.text;
  const auto table = read_csv(s.directory + "/runs.csv");
  EXPECT_EQ(table.header[0], "crack.main.friction");
  EXPECT_EQ(table.column("crack.main.friction"), (std::vector{0.3, 0.3, 0.6, 0.6}));
  EXPECT_LT(table.column("fy_top at 0.2")[2], table.column("fy_top at 0.2")[0]) << "friction stiffens the block";
}

// A square of two triangles and one of eight, as Gmsh writes them.
std::string square(int cells) {
  std::string nodes, elements;
  int count = 0, number = 0;
  const auto node = [&](int i, int j) { return std::to_string(1 + i + (cells + 1) * j); };
  const auto add = [&](const std::string& rest) { ++number, elements += std::to_string(number) + " " + rest + "\n"; };
  for (int j = 0; j <= cells; ++j)
    for (int i = 0; i <= cells; ++i)
      nodes += std::to_string(++count) + " " + std::to_string(1.0 * i / cells) + " " + std::to_string(1.0 * j / cells) +
               " 0\n";
  for (int i = 0; i < cells; ++i) {
    add("1 2 1 1 " + node(i, 0) + " " + node(i + 1, 0));
    add("1 2 2 2 " + node(i, cells) + " " + node(i + 1, cells));
  }
  for (int j = 0; j < cells; ++j)
    for (int i = 0; i < cells; ++i) {
      add("2 2 3 3 " + node(i, j) + " " + node(i + 1, j) + " " + node(i + 1, j + 1));
      add("2 2 3 3 " + node(i, j) + " " + node(i + 1, j + 1) + " " + node(i, j + 1));
    }
  return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n3\n1 1 \"bottom\"\n1 2 \"top\"\n2 3 \"body\"\n"
         "$EndPhysicalNames\n$Nodes\n" +
         std::to_string(count) + "\n" + nodes + "$EndNodes\n$Elements\n" + std::to_string(number) + "\n" + elements +
         "$EndElements\n";
}

TEST(StudyRuns, FollowFilesOfGmshByTheSizeOfTheirElements) {
  const std::string folder = testing::TempDir();
  for (const int cells : {2, 4, 8})
    std::ofstream(folder + "cleft_square" + std::to_string(cells) + ".msh") << square(cells);
  std::ofstream(folder + "cleft_square.toml")
      << "[mesh]\nkind = \"gmsh\"\nfile = \"cleft_square2.msh\"\n[material]\nmodel = \"hencky\"\nyoung = 1e9\npoisson "
         "= 0.3\n"
         "[[boundary]]\non = \"bottom\"\nux = 0.0\nuy = 0.0\n[[boundary]]\non = \"top\"\nux = 0.01\nuy = 0.0\n"
         "[loading]\nsteps = 2\n";
  const std::string study = "scene = \"cleft_square.toml\"\nfiles = [\"cleft_square2.msh\", ";
  const Fresh s("files", study + "\"cleft_square4.msh\", \"cleft_square8.msh\"]\n[[quantity]]\ncolumn = \"fx_top\"\n");
  const StudyResult r = s.run();
  ASSERT_TRUE(r.failed.empty()) << r.failed[0];
  EXPECT_NEAR(r.runs[0].h, 0.5, 1e-12);
  EXPECT_NEAR(r.runs[2].h, 0.125, 1e-12);
  EXPECT_EQ(r.runs[2].mesh, "cleft_square8");
  EXPECT_LT(r.runs[2].value[0], r.runs[0].value[0]) << "softer";
  const Fresh same("files", study + "\"cleft_square2.msh\"]\n[[quantity]]\ncolumn = \"fx_top\"\n");
  EXPECT_THROW(same.run(), InputError) << "not finer";
}

}  // namespace
}  // namespace cleft::tools
