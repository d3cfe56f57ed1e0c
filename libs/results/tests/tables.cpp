// Headers and rows of the tables come from the same columns.
#include "tables.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "cleft/results/counts.hpp"

namespace cleft::results {
namespace {

using Names = std::vector<std::string>;

TEST(Table, HasTheNameOfAColumnAboveItsValue) {
  struct Row {
    int a;
    double b;
    const char* c;
  };
  Table<Row> table{{"a", [](const Row& r) { return r.a; }}, {"b", [](const Row& r) { return r.b; }}};
  table.emplace_back("c", [](const Row& r) { return r.c; });
  std::string lines = header_of(table);
  append_line(table, {1, 0.1, "open"}, lines);
  append_line(table, {-2, 1e-300, ""}, lines);
  EXPECT_EQ(lines, "a,b,c\n1,0.1,open\n-2,1e-300,\n");
}

TEST(HistoryColumns, AreThoseOfTheContents) {
  const Names least = history_columns({});
  EXPECT_EQ(least.front(), "step");
  EXPECT_EQ(least.back(), "energy_imbalance");
  const auto more = [&](const Contents& contents) {
    Names out;
    for (const auto& name : history_columns(contents))
      if (std::ranges::find(least, name) == least.end()) out.push_back(name);
    return out;
  };
  EXPECT_EQ(more({.boundaries = {"top", "left"}}), (Names{"fx_top", "fy_top", "fx_left", "fy_left"}));
  EXPECT_EQ(more({.cracks = {{"a", false}}}), Names{"contact_pressure_work"});
  EXPECT_EQ(more({.cracks = {{"a", false}, {"b", true}}}),
            (Names{"k1_b_start", "k2_b_start", "k1_faces_b_start", "k2_faces_b_start", "k1_b_end", "k2_b_end",
                   "k1_faces_b_end", "k2_faces_b_end", "contact_pressure_work"}));
  EXPECT_EQ(more({.is_plastic = true}), Names{"min_localisation"});
  EXPECT_EQ(more({.grows = true}), Names{"released_energy"});
  EXPECT_EQ(more({.follows_path = true}), (Names{"determinant_sign", "least_pivot"}));
}

TEST(NewtonTable, TellsAnIteration) {
  const NewtonAttempt attempt{3, 0.25, 2, true};
  const solve::Iteration iteration{
      .residual = 1e-3, .flow_changes = 4, .kept = true, .largest = {solve::LargestResidual::At::Flow, {0.5, 1.0}}};
  std::string line;
  append_line(newton_table(), {attempt, 5, iteration}, line);
  EXPECT_EQ(line, "3,0.25,5,0.001,0,0,0,0,0,0,0,0,0,1,4,flow,0.5,1,2,1\n");
}

TEST(GrowthTable, NamesCrackAndTip) {
  growth::Step step;
  step.number = 7;
  step.load = 0.5;
  growth::Advance advance;
  advance.tip = {1, 1};
  advance.number = 2;
  advance.length = 0.125;
  advance.stop = growth::Stop::Boundary;
  std::string line;
  append_line(growth_table({.cracks = {{"a", false}, {"b", false}}}), {step, advance, Vec2(3.0, 4.0), 6.5}, line);
  EXPECT_EQ(line, "7,0.5,b,end,2,3,4,0.125,0,0,nan,nan,nan,0,6.5,boundary,nan\n");
}

TEST(CrackTable, TellsAContactPoint) {
  ProfilePoint point;
  point.side = geometry::Side::Right;
  point.s = 0.5;
  point.reference = {1.0, 2.0};
  point.current = {3.0, 4.0};
  point.status = contact::Status::Slip;
  std::string line;
  append_line(crack_table(), {0.75, 9, point}, line);
  EXPECT_EQ(line, "0.75,right,0.5,1,2,3,4,0,0,0,0,0,slip,0,0,9,0,0,0\n");
  const auto names = names_of(crack_table());
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size()) << "every name once";
}

TEST(Counts, AddUpAndKeepTheFirstJumpAndTheWorstRounding) {
  Counts counts;
  growth::Step step;
  step.number = 1;
  step.load = 0.1;
  step.cuts = 2;
  step.iterations_before = 5;
  step.iterations.resize(3);
  step.left.residual = 1e-6;
  step.rounded = 1e-3;
  step.jumped = true;
  counts.count(step);
  step.number = 2;
  step.load = 0.2;
  step.rounded = 1e-4;
  step.left.residual = 1e-9;
  counts.count(step);
  EXPECT_EQ(counts.increments, 2);
  EXPECT_EQ(counts.iterations, 16);
  EXPECT_EQ(counts.cuts, 4);
  EXPECT_EQ(counts.worst_residual, 1e-6);
  EXPECT_EQ(counts.rounded.increments, 2);
  EXPECT_EQ(counts.rounded.worst, 1e-3);
  EXPECT_EQ(counts.rounded.load, 0.1);
  EXPECT_EQ(counts.jumps.increments, 2);
  EXPECT_EQ(counts.jumps.load, 0.1);
  EXPECT_EQ(counts.median_order(), 0.0) << "no correction shows one";
  counts.orders = {2.0, 1.0, 3.0};
  EXPECT_EQ(counts.median_order(), 2.0);
}

}  // namespace
}  // namespace cleft::results
