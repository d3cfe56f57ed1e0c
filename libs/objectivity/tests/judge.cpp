#include "judge.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace cleft::objectivity {
namespace {

SwapMesh mesh_of(double h, double pressure) {
  SwapMesh out{"", h, {}, {}};
  out.differences = {{"pressure main", false, {0.5, 0.5, 0.5}},
                     {"pressure main, 0.1 to 0.9", true, {pressure / 2.0, pressure, 0.0}}};
  return out;
}

SwapResult judged(const std::vector<SwapMesh>& meshes, double tolerance) {
  SwapOptions options;
  options.tolerance = tolerance;
  SwapResult out;
  out.sides = judge_sides(meshes, options);
  out.verdict = verdict_of(out);
  return out;
}

TEST(Judge, TheFinestMeshAgainstTheTolerance) {
  EXPECT_EQ(judged({mesh_of(0.1, 0.02)}, 0.03).verdict, Verdict::Holds);
  EXPECT_EQ(judged({mesh_of(0.1, 0.04), mesh_of(0.05, 0.02)}, 0.03).verdict, Verdict::Holds);
  EXPECT_EQ(judged({mesh_of(0.1, 0.02), mesh_of(0.05, 0.04)}, 0.03).verdict, Verdict::Fails);
  EXPECT_EQ(judged({mesh_of(0.1, 0.02)}, 0.0).verdict, Verdict::Fails);
}

TEST(Judge, ALargerDifferenceThatFallsForCertain) {
  const auto falling = [](double order, double scatter) {
    std::vector<SwapMesh> out;
    for (const double h : {0.1, 0.05, 0.025, 0.0125, 0.00625}) {
      scatter = -scatter;
      out.push_back(mesh_of(h, std::pow(h, order) * (1.0 + scatter)));
    }
    return judged(out, 0.0);
  };
  EXPECT_EQ(falling(1.0, 0.01).verdict, Verdict::Holds);
  EXPECT_NEAR(falling(1.0, 0.01).sides[1].order, 1.0, 0.05);
  EXPECT_EQ(falling(0.1, 0.01).verdict, Verdict::Fails) << "hardly falls";
  EXPECT_EQ(falling(1.0, 0.9).verdict, Verdict::Fails) << "scatters too much to tell";
}

TEST(Judge, WhatIsToldOnlyHasNoVerdict) {
  const auto result = judged({mesh_of(0.1, 0.001)}, 0.01);
  EXPECT_FALSE(result.sides[0].verdict.has_value());
  EXPECT_EQ(result.sides[0].difference, std::vector{0.5});
  EXPECT_EQ(result.verdict, Verdict::Holds);
}

TEST(Judge, CannotTellWithoutContactOrWithoutARun) {
  EXPECT_EQ(judged({mesh_of(0.1, std::numeric_limits<double>::quiet_NaN())}, 0.01).verdict, Verdict::Unknown);
  auto result = judged({mesh_of(0.1, 0.001)}, 0.01);
  result.failed = {"16x32 left: ended at load 0.2"};
  EXPECT_EQ(verdict_of(result), Verdict::Unknown);
  auto failing = judged({mesh_of(0.1, 0.1)}, 0.01);
  failing.failed = result.failed;
  EXPECT_EQ(verdict_of(failing), Verdict::Fails) << "a difference that is there does not go away";
}

TEST(Judge, AMeshOfWhichARunFailedIsLeftOut) {
  auto without = mesh_of(0.05, 1.0);
  without.differences.clear();
  const auto result = judged({mesh_of(0.1, 0.001), without}, 0.01);
  EXPECT_EQ(result.sides[1].h, std::vector{0.1});
}

}  // namespace
}  // namespace cleft::objectivity
