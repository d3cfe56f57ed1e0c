// Studies with the real program, on meshes small enough for a test.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "cleft/support/files.hpp"
#include "fresh_study.hpp"
#include "shell.hpp"

namespace cleft::tools {
namespace {

TEST(Study, FollowsColumnsAndProfilesOverMeshesAndSides) {
  const Fresh s("block", block("cells = [[4, 8], [8, 16], [16, 32]]\n"
                               "sweep = { key = \"crack.main.negative_side\", values = [\"left\", \"right\"] }\n"
                               "[[quantity]]\ncolumn = \"fy_top\"\nload = 0.3\n"
                               "[[quantity]]\ncolumn = \"pressure\"\ncrack = \"main\"\nload = 0.3\nalong = \"x\"\n"));
  const StudyResult r = s.run();
  ASSERT_TRUE(r.failed.empty()) << r.failed[0];
  ASSERT_EQ(r.runs.size(), 6u);
  ASSERT_EQ(r.series.size(), 4u);
  EXPECT_EQ(r.series[1].variant, "right");
  for (const auto& series : r.series) {
    const bool profile = series.quantity == 1;
    ASSERT_EQ(series.runs.size(), profile ? 2u : 3u) << "the finest profile is the reference";
    for (const double error : series.error)
      EXPECT_TRUE(profile ? error > 0.0 : std::isnan(error)) << "no limit by three";
    if (!profile) {
      EXPECT_LT(series.from_finest[1], series.from_finest[0]);
      EXPECT_GT(series.fit.finest_pm, 0.0);
    }
  }
  const auto table = read_csv(s.directory + "/study.csv");
  EXPECT_EQ(table.rows.size(), 10u);
  EXPECT_EQ(table.column("value")[0], r.runs[0].value[0]);
  EXPECT_EQ(read_csv(s.directory + "/fits.csv").rows.size(), 4u);
  EXPECT_EQ(table.column("factorise_seconds")[0], r.runs[0].phases.at("factorise"));
  std::vector<double> unknowns, seconds;
  for (std::size_t k = 3; k < 6; ++k) {
    unknowns.push_back(static_cast<double>(r.runs[k].unknowns));
    seconds.push_back(r.runs[k].phases.at("factorise"));
  }
  const auto costs = read_csv(s.directory + "/costs.csv");
  ASSERT_EQ(costs.rows.size(), r.costs.size());
  int seen = 0;
  for (std::size_t k = 0; k < r.costs.size(); ++k)
    if (r.costs[k].variant == "right" && r.costs[k].what == "factorise_seconds") {
      ++seen;
      EXPECT_EQ(r.costs[k].fit.order, convergence::fit_power(unknowns, seconds).order);
      EXPECT_EQ(costs.column("exponent")[k], r.costs[k].fit.order);
    }
  EXPECT_EQ(seen, 1);
  for (const char* figure : {"/convergence.svg", "/cost.svg"}) {
    const std::string svg = read_bytes(s.directory + figure);
    EXPECT_NE(svg.find("fy_top at 0.3, left"), std::string::npos) << figure;
  }
}

// Both faces have points: of opposite shear tractions, and at places of their own once they have slid.
TEST(Study, ComparesOneFaceWhereBothHavePoints) {
  const std::string shear = "[[quantity]]\ncrack = \"main\"\ncolumn = \"tt\"\nrange = [0.01, 0.03]\n";
  const Fresh s("faces", block("cells = [[4, 8], [8, 16], [16, 32]]\n"
                               "sweep = { key = \"crack.main.negative_side\", values = [\"left\", \"both\"] }\n" +
                               shear + shear + "side = \"left\"\n"));
  const std::string both_only = "[[quantity]]\ncrack = \"main\"\ncolumn = \"tt\"\nside = \"right\"\n";
  const StudyResult r = s.run();
  ASSERT_TRUE(r.failed.empty()) << r.failed[0];
  ASSERT_EQ(r.series.size(), 4u);
  for (std::size_t k = 0; k < 2; ++k) {
    const double left = r.series[0].error[k], both = r.series[1].error[k], said = r.series[3].error[k];
    EXPECT_EQ(both, said) << "the left face if nothing is said";
    EXPECT_LT(std::fabs(both - left), 0.2 * left);
  }
  const Fresh missing("no_face", block("cells = [[4, 8], [8, 16]]\n" + both_only));
  try {
    missing.run();
    ADD_FAILURE() << "accepted";
  } catch (const InputError& error) {
    EXPECT_EQ(error.key(), "quantity[0].side");
    EXPECT_NE(error.problem().find("the right face of crack 'main' has no points"), std::string::npos);
  }
}

TEST(Study, SaysNothingOfOrdersThatTwoMeshesDoNotShow) {
  const Fresh s("two", block("cells = [[4, 8], [8, 16]]\n[[quantity]]\ncolumn = \"fy_top\"\nload = 0.1\n"
                             "[[quantity]]\ncrack = \"main\"\ncolumn = \"pressure\"\nload = 0.1\n"));
  const StudyResult r = s.run();
  ASSERT_EQ(r.series.size(), 2u);
  for (const auto& series : r.series) {
    EXPECT_TRUE(std::isnan(series.fit.order));
    for (const double error : series.error) EXPECT_TRUE(std::isnan(error));
  }
  const auto& load = r.series[0];
  const double coarse = r.runs[0].value[0], fine = r.runs[1].value[0];
  EXPECT_EQ(load.from_finest, (std::vector{std::fabs(coarse - fine) / std::fabs(fine), 0.0}));
}

// The number of contact points grows without a limit, but a fit of three meshes has one.
TEST(Study, TellsNoErrorAgainstALimitThatIsNotDetermined) {
  const Fresh s("no_limit", block("cells = [[4, 8], [8, 16], [16, 32]]\n[[quantity]]\ncolumn = \"contact_points\"\n"
                                  "load = 0.1\nlimit_within = [-1e9, 1e9]\n"));
  const StudyResult r = s.run();
  ASSERT_EQ(r.series.size(), 1u);
  const auto& points = r.series[0];
  ASSERT_FALSE(points.fit.determined);
  EXPECT_TRUE(std::isfinite(points.fit.limit));
  EXPECT_FALSE(points.has_errors);
  const auto table = read_csv(s.directory + "/study.csv");
  const auto error = table.column("error"), relative = table.column("relative_error"),
             apart = table.column("from_finest"), value = table.column("value");
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_TRUE(std::isnan(error[k]) && std::isnan(relative[k]));
    EXPECT_EQ(apart[k], std::fabs(value[k] - value[2]) / value[2]);
  }
  EXPECT_GT(apart[0], 0.5);
  for (const char* figure : {"/convergence.svg", "/cost.svg"})
    EXPECT_NE(read_bytes(s.directory + figure).find("relative difference from the finest mesh"), std::string::npos);
  EXPECT_TRUE(r.missed.empty()) << "nothing is known to miss";
  ASSERT_EQ(r.undecided.size(), 1u);
  EXPECT_NE(r.undecided[0].find("limit is not determined: 3 meshes"), std::string::npos) << r.undecided[0];
  EXPECT_TRUE(std::isnan(read_csv(s.directory + "/fits.csv").column("limit")[0]));
}

// What is printed, written and checked of results that do not change is their value.
TEST(Study, EqualResultsHaveALimitAndErrorsButNoOrder) {
  const Fresh s("equal", block("[[sequence]]\nkey = \"solver.max_iterations\"\nvalues = [14, 13, 12]\nh = \"value\"\n"
                               "[[quantity]]\ncolumn = \"fy_top\"\nload = 0.1\nlimit_within = [-1e9, 0]\n"));
  const Outcome told = call("converge " + s.file + " -o " + s.directory);
  EXPECT_EQ(told.code, 0) << told.text;
  EXPECT_NE(told.text.find("exact to rounding"), std::string::npos) << told.text;
  EXPECT_NE(told.text.find("  limit -"), std::string::npos) << told.text;
  EXPECT_EQ(told.text.find("limit NOT DETERMINED"), std::string::npos) << told.text;
  EXPECT_EQ(told.text.find("no error is known"), std::string::npos) << told.text;
  const auto table = read_csv(s.directory + "/study.csv");
  EXPECT_EQ(read_csv(s.directory + "/fits.csv").column("limit")[0], table.column("value")[2]);
  EXPECT_EQ(table.column("error"), (std::vector{0.0, 0.0, 0.0}));
}

TEST(Study, MeasuresErrorsAndIsACheckWhereOrdersAreAskedFor) {
  const std::string scene = "scene = \"" + kVerification + "scenes/manufactured.toml\"\n";
  const std::string four = scene + "cells = [[4, 4], [8, 8], [16, 16], [32, 32]]\n";
  const Fresh holds("orders", four + "[[quantity]]\nerror = \"l2\"\norder_within = [1.5, 2.5]\n");
  const StudyResult r = holds.run();
  EXPECT_TRUE(r.missed.empty() && r.undecided.empty());
  const auto& fit = r.series[0].fit;
  EXPECT_TRUE(fit.determined);
  EXPECT_NEAR(fit.observed_order.back(), std::log2(r.series[0].error[2] / r.series[0].error[3]), 1e-6);
  const auto table = read_csv(holds.directory + "/fits.csv");
  EXPECT_EQ(table.column("order_pm")[0], fit.order_pm);
  EXPECT_EQ(table.column("window")[0], 4.0);
  EXPECT_NE(read_bytes(holds.directory + "/fits.csv").find(",monotone,"), std::string::npos);
  const Fresh misses("orders", four + "[[quantity]]\nerror = \"energy\"\norder_within = [1.9, 2.1]\n");
  EXPECT_EQ(misses.run().missed.size(), 1u);
  const Fresh narrow("orders", four + "[[quantity]]\nerror = \"l2\"\norder_within = [1.0, 2.0]\n");
  EXPECT_EQ(narrow.run().undecided.size(), 1u) << "the interval reaches beyond";
  const Fresh few("orders", scene + "cells = [[4, 4], [8, 8]]\n[[quantity]]\nerror = \"l2\"\norder_within = [0, 5]\n");
  const StudyResult two = few.run();
  ASSERT_EQ(two.undecided.size(), 1u);
  EXPECT_NE(two.undecided[0].find("2 meshes do not determine an order"), std::string::npos) << two.undecided[0];
}

// A process starts with its parent's peak in getrusage's books.
TEST(Study, TheMemoryOfARunIsItsOwn) {
  const std::vector<char> large(std::size_t{400} << 20, 'x');
  const Fresh s("memory", block("cells = [[4, 8], [8, 16]]\n[[quantity]]\ncolumn = \"fy_top\"\nload = 0.1\n"));
  for (const auto& run : s.run().runs) {
    EXPECT_GT(run.megabytes, 5.0);
    EXPECT_LT(run.megabytes, 300.0) << "of " << large.size() / 1000000 << " MB here";
  }
}

TEST(Study, RefusesWhatTheSceneDoesNotHaveBeforeAnythingRuns) {
  const std::string cells = "cells = [[4, 8], [8, 16]]\n";
  const std::pair<const char*, const char*> faults[] = {
      {"[[quantity]]\ncolumn = \"fy_tip\"\n", "quantity[0].column: history.csv has no column 'fy_tip'"},
      {"[[quantity]]\nerror = \"l2\"\n", "quantity[0].error: the scene has no [exact] solution"},
      {"[[quantity]]\ncolumn = \"presure\"\ncrack = \"main\"\n", "quantity[0].column: no number in a crack's file"},
      {"[[quantity]]\ncolumn = \"slip\"\ncrack = \"side\"\n", "quantity[0].crack: the scene has no crack 'side'"},
      {"[[quantity]]\ncolumn = \"slip\"\ncrack = \"main\"\nreference = \"no.csv\"\n", "no.csv: cannot be read"}};
  for (const auto& [text, message] : faults) {
    const Fresh s("refused", block(cells + text));
    try {
      s.run();
      ADD_FAILURE() << message;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(message), std::string::npos) << error.what();
    }
    EXPECT_FALSE(std::filesystem::exists(s.directory));
  }
  const Fresh uncut("refused", "scene = \"" + kVerification + "scenes/block.toml\"\n" + cells +
                                   "set = [\"crack.main.points=[[0.011,0.011],[0.012,0.012]]\"]\n"
                                   "[[quantity]]\ncolumn = \"fy_top\"\n");
  EXPECT_THROW(uncut.run(), InputError) << "what only shows on a mesh, too";
  EXPECT_FALSE(std::filesystem::exists(uncut.directory));
  const Fresh coarser("refused", block("cells = [[8, 16], [4, 8]]\n[[quantity]]\ncolumn = \"fy_top\"\n"));
  EXPECT_THROW(coarser.run(), InputError);
}

TEST(Study, TellsWhatIsWrongWithASceneAtTheLineOfTheStudy) {
  const std::string scene = "scene = \"" + kVerification + "scenes/block.toml\"\n",
                    cells = "cells = [[8, 16], [16, 32]]\n", quantity = "[[quantity]]\ncolumn = \"fy_top\"\n";
  const std::pair<std::string, const char*> wrong[] = {
      {scene + "set = [\"loading.steps=4\",\n\"material.yung=1\"]\n" + cells, ":3:1: material.yung: unknown key"},
      {scene + cells + "sweep = { key = \"material.poisson\", values = [0.2, 0.7] }\n",
       ":3:52: material.poisson: 0.7 is out of range"},
      {scene + "cells = [[8, 16],\n[0, 4]]\n", ":3:1: mesh.cells"},
      {cells + "scene = \"nowhere.toml\"\n", ":2:9: scene: "}};
  for (const auto& [text, message] : wrong) {
    const Fresh s("wrong_scene", text + quantity);
    try {
      s.run();
      ADD_FAILURE() << message;
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()).find(s.file + message), 0u) << error.what();
    }
    EXPECT_FALSE(std::filesystem::exists(s.directory));
  }
}

}  // namespace
}  // namespace cleft::tools
