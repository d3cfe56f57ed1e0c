// Reports made by the program: their files, what they say, and what becomes of runs that lack something.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "cleft/support/files.hpp"
#include "shell.hpp"

namespace cleft::tools {
namespace {

namespace fs = std::filesystem;

// A folder with a run, solved once for all tests.
std::string solved(const std::string& name, const std::string& arguments) {
  const std::string folder = testing::TempDir() + "cleft_report_" + name;
  if (!fs::exists(folder + "/run.json")) {
    const Outcome o = call("run " + kScenes + arguments + " -o " + folder);
    EXPECT_TRUE(o.code == 0 || o.code == 3) << o.text;
  }
  return folder;
}

const std::string kSmall =
    "block.toml --set 'mesh.cells=[8,16]' --set loading.steps=10 "
    "--set 'loading.outputs=[0.1,0.2,0.3,0.4,0.5,0.6,0.7,0.8,0.9,1.0]' ";
std::string smooth() { return solved("smooth", kSmall); }
std::string rough() {
  return solved("rough", kSmall + "--set crack.main.friction=0.6 --set 'crack.main.negative_side=both'");
}

// A copy of a run that a test may spoil.
std::string copy_of(const std::string& run, const std::string& name) {
  const std::string folder = fresh(name);
  fs::copy(run, folder);
  return folder;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::string text_of(const std::string& path) { return read_bytes(path); }

// Rows of a data block in a script of gnuplot.
std::vector<std::vector<double>> rows_of(const std::string& script, const std::string& block) {
  std::istringstream lines(script.substr(script.find(block + " << EOD\n") + block.size() + 8));
  std::vector<std::vector<double>> rows;
  for (std::string line; std::getline(lines, line) && line != "EOD";) {
    std::istringstream words(line);
    std::vector<double> row;
    for (double v; words >> v;) row.push_back(v);
    if (!row.empty()) rows.push_back(row);
  }
  return rows;
}

TEST(Report, DrawsEveryFigureTwiceAndPutsAllIntoOnePage) {
  const std::string out = fresh("figures");
  const Outcome o = call("report " + smooth() + " -o " + out);
  ASSERT_EQ(o.code, 0) << o.text;
  const std::string page = text_of(out + "/index.html");
  for (const std::string name :
       {"reaction_x", "reaction_y", "reaction_y_displacement", "crack_main_tn", "crack_main_tt", "crack_main_pressure",
        "crack_main_slip", "crack_main_gap", "energies", "contact_points", "max_slip", "newton", "increments",
        "iterations", "phases", "stress_yy_0009"}) {
    EXPECT_TRUE(has(text_of(out + "/" + name + ".svg"), "<svg")) << name;
    EXPECT_EQ(text_of(out + "/" + name + ".png").substr(1, 3), "PNG") << name;
    EXPECT_TRUE(has(page, "<figure id=\"" + name + "\"><svg")) << name;
  }
  for (int output = 0; output < 10; ++output)
    EXPECT_TRUE(fs::exists(out + "/stress_yy_000" + std::to_string(output) + ".png")) << output;
  EXPECT_TRUE(has(page, "Plane-strain compression of a block"));
  EXPECT_TRUE(has(page, "&quot;friction&quot;: 0.3")) << "the scene as solved";
}

TEST(Report, IsWrittenBesideTheRunUnlessToldOtherwise) {
  const std::string run = copy_of(smooth(), "report_default");
  const Outcome o = call("report " + run + "/");
  ASSERT_EQ(o.code, 0) << o.text;
  EXPECT_TRUE(fs::exists(run + "/report/index.html")) << o.text;
}

TEST(Report, ShowsTheNumbersOfTheRunWithTheirSigns) {
  const std::string out = fresh("numbers");
  ASSERT_EQ(call("report " + smooth() + " -o " + out).code, 0);
  const auto history = read_csv(smooth() + "/history.csv");
  const auto force = rows_of(text_of(out + "/reaction_y.gp"), "$curve1");  // bottom, top
  ASSERT_EQ(force.size(), history.rows.size());
  EXPECT_NEAR(force.back()[1], 1e-6 * history.column("fy_top").back(), 1e-12);
  EXPECT_TRUE(has(text_of(out + "/reaction_y.svg"), "force on the body fy, MN/m"));
  const auto along = rows_of(text_of(out + "/reaction_y_displacement.gp"), "$curve0");
  EXPECT_NEAR(along.back()[0], -10.0, 1e-12) << "uy of the top in mm";
  EXPECT_NEAR(along.front()[0], -1.0, 1e-12);
  const auto profile = read_csv(smooth() + "/crack_main.csv");
  const auto load = profile.column("load"), tn = profile.column("tn");
  double least = 0.0, drawn = 0.0;
  for (std::size_t k = 0; k < tn.size(); ++k)
    if (load[k] == 1.0) least = std::min(least, tn[k]);
  ASSERT_LT(least, -1e8);
  for (const auto& row : rows_of(text_of(out + "/crack_main_tn.gp"), "$curve5")) drawn = std::min(drawn, row[1]);
  EXPECT_NEAR(drawn, 1e-6 * least, 1e-9 * std::fabs(least)) << "the sixth curve is that of full load, MPa";
  EXPECT_TRUE(has(text_of(out + "/crack_main_tn.svg"), "tn, MPa"));
  // the mesh: the corner of the top that is prescribed to go from (0, 80) to (-10, 70) mm
  bool corner = false;
  for (const auto& row : rows_of(text_of(out + "/stress_yy_0009.gp"), "$triangles"))
    corner |= std::fabs(row[0] + 10.0) < 1e-3 && std::fabs(row[1] - 70.0) < 1e-3;
  EXPECT_TRUE(corner);
}

TEST(Report, DisplacementsThatNobodyWouldSeeAreMagnifiedAndTheFigureSaysSo) {
  const std::string small =
      solved("small", kSmall + "--set boundary.top.uy=-1e-5 --set boundary.top.ux=0.0 --set loading.steps=2 " +
                          "--set 'loading.outputs=[1.0]'");
  const std::string out = fresh("magnified");
  ASSERT_EQ(call("report " + small + " -o " + out).code, 0);
  const std::string script = text_of(out + "/stress_yy_0000.gp");
  EXPECT_TRUE(has(script, "displacements x 200'") && has(script, "'Y + 200 uy, mm'"));
  // a twentieth of the diagonal of 89.4 mm would be 447 times 0.01 mm, of the round factors 200 is the next below
  double top = 0.0;
  for (const auto& row : rows_of(script, "$triangles")) top = std::max(top, row[1]);
  EXPECT_NEAR(top, 80.0 - 200 * 0.01, 1e-2);
  EXPECT_FALSE(has(text_of(out + "/index.html"), "\"factor\":1.0,"));
}

TEST(Report, DrawsSeveralRunsOverEachOther) {
  const std::string out = fresh("overlay");
  ASSERT_EQ(call("report " + smooth() + " " + rough() + " -o " + out).code, 0);
  for (const char* file : {"/reaction_y.svg", "/newton.svg", "/increments.svg", "/phases.svg", "/max_slip.svg"})
    for (const char* run : {"cleft_report_smooth", "cleft_report_rough"})
      EXPECT_TRUE(has(text_of(out + file), run)) << file << " " << run;
  const std::string slip = text_of(out + "/crack_main_slip.svg");
  EXPECT_TRUE(has(slip, "cleft_report_smooth: load 1, left face") &&
              has(slip, "cleft_report_rough: load 1, right face"));
  EXPECT_TRUE(fs::exists(out + "/run1_stress_yy_0009.svg") && fs::exists(out + "/run2_stress_yy_0009.svg"));
  const std::string page = text_of(out + "/index.html");
  EXPECT_TRUE(has(page, "<th>cleft_report_smooth</th><th>cleft_report_rough</th>"));
}

TEST(Report, SaysWhatDiffersBetweenRunsAndWhatEachEndsWith) {
  const std::string pulled = solved("pulled", kSmall + "--set boundary.top.name=roof --set 'mesh.cells=[4,8]'");
  const std::string out = fresh("differences"), page = out + "/index.html", heading = "What differs between the scenes";
  ASSERT_EQ(call("report " + smooth() + " " + rough() + " -o " + out).code, 0);
  std::string text = text_of(page);
  EXPECT_TRUE(has(text, "<tr><td>crack.main.friction</td><td>0.3</td><td>0.6</td></tr>")) << text.substr(0, 9000);
  EXPECT_TRUE(has(text, "<td>crack.main.negative_side</td>"));
  EXPECT_FALSE(has(text, "<td>material.young</td>")) << "what they have in common";
  ASSERT_EQ(call("report " + smooth() + " " + pulled + " -o " + out).code, 0);
  text = text_of(page);
  EXPECT_TRUE(has(text, "<tr><td>mesh.cells</td><td>[8,16]</td><td>[4,8]</td></tr>"));
  EXPECT_TRUE(has(text, "fy_top at the end") && has(text, "fy_roof at the end")) << "rows of both runs";
  ASSERT_EQ(call("report " + smooth() + " -o " + out).code, 0);
  EXPECT_FALSE(has(text_of(page), heading)) << "one run differs from nothing";
}

TEST(Report, RunsOfOneNameAreToldApartByTheirPaths) {
  const std::string a = fresh("same_a"), b = fresh("same_b");
  for (const auto& folder : {a, b}) {
    fs::create_directories(folder);
    fs::copy(smooth(), folder + "/run");
  }
  ASSERT_EQ(call("report " + a + "/run " + b + "/run -o " + a).code, 0);
  const std::string slip = text_of(a + "/max_slip.svg");
  EXPECT_TRUE(has(slip, ">cleft_program_same_a/run<") && has(slip, ">cleft_program_same_b/run<"));
}

TEST(Report, WhatARunLacksIsLeftOut) {
  const std::string plain = solved("plain", "plain.toml --set loading.steps=4 --set 'loading.outputs=[1.0]'");
  const std::string out = fresh("lacking");
  ASSERT_EQ(call("report " + plain + " -o " + out).code, 0);
  std::string page = text_of(out + "/index.html");
  EXPECT_FALSE(has(page, "Along the cracks") || has(page, "Contact points") || has(page, "Advances of tips"));
  EXPECT_TRUE(has(page, "Reactions") && has(page, "<canvas")) << "one output";

  const std::string bare = copy_of(smooth(), "bare");
  for (const char* file : {"newton.csv", "fields.pvd", "run.json", "checkpoint"}) fs::remove(bare + "/" + file);
  ASSERT_EQ(call("report " + bare + " -o " + out).code, 0);
  page = text_of(out + "/index.html");
  EXPECT_FALSE(has(page, "<canvas") || has(page, "id=\"newton\"") || has(page, "id=\"phases\"") ||
               has(page, "Scene as solved"));
  EXPECT_TRUE(has(page, "this run has not ended") && has(page, "id=\"crack_main_tn\""));
  EXPECT_FALSE(fs::exists(out + "/stress_yy_0000.svg")) << "of the report before";

  fs::copy(smooth() + "/fields.pvd", bare + "/fields.pvd");
  fs::remove(bare + "/fields_0003.vtu");
  ASSERT_EQ(call("report " + bare + " -o " + out).code, 0);
  EXPECT_FALSE(fs::exists(out + "/stress_yy_0003.svg"));
  EXPECT_TRUE(fs::exists(out + "/stress_yy_0004.svg")) << "outputs keep the numbers of their files";
}

TEST(Report, ARunThatFailedSaysSo) {
  const std::string failed = solved("failed", "block.toml --set solver.max_iterations=3 --set solver.min_step=0.01");
  const std::string out = fresh("failed_report");
  ASSERT_EQ(call("report " + failed + " -o " + out).code, 0);
  EXPECT_TRUE(has(text_of(out + "/index.html"), "failed at load"));
}

TEST(Report, GrowthIsDrawnAndListed) {
  const std::string wings = solved("wings", "wing_crack.toml");
  const std::string out = fresh("growth_report");
  const auto growth = read_csv(wings + "/growth.csv");
  ASSERT_GT(growth.rows.size(), 0u);
  ASSERT_EQ(call("report " + wings + " -o " + out).code, 0);
  const std::string page = text_of(out + "/index.html");
  EXPECT_TRUE(has(page, "Advances of tips") && has(page, "id=\"growth\""));
  // several outputs have one load: each is shown as the increment that it is of
  const auto steps = read_csv(wings + "/crack_main.csv").column("step");
  for (const double step : steps)
    ASSERT_TRUE(has(page, ", increment " + std::to_string(static_cast<int>(step)) + "\"")) << step;
  EXPECT_FALSE(has(page, ", increment " + std::to_string(static_cast<int>(growth.column("step")[0]) - 1) + "\""));
}

TEST(Report, AWrongFolderOrADamagedFileIsToldAndNothingIsWritten) {
  const std::string out = fresh("unwritten"), empty = fresh("empty_run");
  fs::create_directories(empty);
  const auto refused = [&](const std::string& run, const std::string& message) {
    const Outcome o = call("report " + run + " -o " + out);
    EXPECT_EQ(o.code, 2) << run;
    EXPECT_TRUE(has(o.text, message)) << o.text;
    EXPECT_FALSE(fs::exists(out)) << run;
  };
  refused(empty + "_not", "there is no such folder");
  refused(empty, "not the folder of a run: it has no history.csv");
  refused(smooth() + " " + empty, "not the folder of a run");
  refused(smooth() + " --field heat", "has no field 'heat'; allowed: stress_yy, stress_xx");
  const std::string damaged = copy_of(smooth(), "damaged");
  const auto spoil = [&](const std::string& file, const std::string& text) {
    std::ofstream(damaged + "/" + file) << text;
    return damaged + "/" + file;
  };
  refused(damaged, spoil("crack_main.csv", "load,side,s,step\n0.5,left,x,1\n") + ": column");
  fs::remove(damaged + "/crack_main.csv");
  refused(damaged, spoil("fields_0001.vtu", "<VTKFile/>") + ": not a file of VTK");
  fs::remove(damaged + "/fields_0001.vtu");
  refused(damaged, spoil("run.json", "{") + ": ");
  refused(damaged, spoil("history.csv", "step,load\n1,half\n") + ": column load: 'half' is not a number");
  EXPECT_EQ(call("report").code, 2);
}

TEST(Report, SaysWhatToInstallWhereGnuplotIsMissing) {
  const Outcome o = call("report " + smooth() + " -o " + fresh("no_gnuplot"), "PATH=/nowhere ");
  EXPECT_EQ(o.code, 2);
  EXPECT_TRUE(has(o.text, "gnuplot-nox")) << o.text;
}

TEST(Report, ReplacesItsOwnFiguresAndLeavesOtherFilesAlone) {
  const std::string out = fresh("replaced");
  fs::create_directories(out);
  for (const char* file : {"stress_yy_0042.svg", "notes.gp"}) std::ofstream(out + "/" + file) << "keep";
  ASSERT_EQ(call("report " + smooth() + " -o " + out).code, 0);
  ASSERT_EQ(call("report " + smooth() + " --field mean_stress -o " + out).code, 0);
  EXPECT_TRUE(fs::exists(out + "/mean_stress_0009.svg"));
  EXPECT_FALSE(fs::exists(out + "/stress_yy_0009.svg") || fs::exists(out + "/stress_yy_0009.gp"));
  for (const char* file : {"stress_yy_0042.svg", "notes.gp"}) EXPECT_EQ(text_of(out + "/" + file), "keep") << file;
}

}  // namespace
}  // namespace cleft::tools
