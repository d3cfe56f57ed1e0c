#include "judge.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace cleft::objectivity {
namespace {

SwapMesh mesh_of(double h, double pressure) {
  SwapMesh out{"", h, {}, {}};
  out.differences = {{"pressure main", false, {0.5, 0.5, 0.5}, ""},
                     {"pressure main, 0.1 to 0.9", true, {pressure / 2.0, pressure, 0.0}, ""}};
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

// On meshes that are halved.
Verdict of_sequence(const std::vector<double>& pressure, double tolerance) {
  std::vector<SwapMesh> meshes;
  for (const double value : pressure) meshes.push_back(mesh_of(0.1 * std::pow(0.5, meshes.size()), value));
  return judged(meshes, tolerance).verdict;
}

TEST(Judge, TheFinestMeshAgainstTheTolerance) {
  EXPECT_EQ(of_sequence({0.02}, 0.03), Verdict::Holds);
  EXPECT_EQ(of_sequence({0.04, 0.02}, 0.03), Verdict::Holds);
  EXPECT_EQ(of_sequence({0.02}, 0.0), Verdict::Fails);
}

TEST(Judge, CannotTellOfFewMeshesWhetherADifferenceFallsUnlessItIsGross) {
  EXPECT_EQ(of_sequence({0.04}, 0.03), Verdict::Unknown);
  EXPECT_EQ(of_sequence({0.02, 0.04}, 0.03), Verdict::Unknown);
  EXPECT_EQ(of_sequence({0.16, 0.08, 0.04}, 0.03), Verdict::Unknown) << "three meshes determine no order";
  EXPECT_EQ(of_sequence({0.31}, 0.03), Verdict::Fails) << "above ten times the tolerance";
  EXPECT_EQ(of_sequence({0.1, 0.31}, 0.03), Verdict::Fails);
}

TEST(Judge, ADifferenceThatDoesNotFallFails) {
  EXPECT_EQ(of_sequence({0.2, 0.05, 0.04, 0.045}, 0.03), Verdict::Fails) << "diverges";
  EXPECT_EQ(of_sequence({0.04, 0.03, 0.06, 0.05}, 0.03), Verdict::Fails) << "no smaller than on the coarsest";
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
  EXPECT_EQ(falling(1.0, 0.9).verdict, Verdict::Unknown) << "scatters too much to tell";
  EXPECT_EQ(falling(0.5, 0.01).verdict, Verdict::Unknown) << "the interval holds the required order";
}

// The requirement is beyond the interval: it falls, and too slowly.
TEST(Judge, ADifferenceThatFallsTooSlowlyForCertainFails) {
  SwapOptions options;
  options.tolerance = 0.0;
  options.least_order = 2.0;
  std::vector<SwapMesh> meshes;
  for (const double h : {0.1, 0.05, 0.025, 0.0125, 0.00625}) meshes.push_back(mesh_of(h, h));
  EXPECT_EQ(judge_sides(meshes, options)[1].verdict, Verdict::Fails);
}

TEST(Judge, AQuantityThatCannotBeToldLeavesTheCheckOpen) {
  const auto with_doubt = [](double energy) {
    auto mesh = mesh_of(0.1, std::numeric_limits<double>::quiet_NaN());
    mesh.differences[1].doubt = "a face has one point";
    mesh.differences.push_back({"elastic_energy", true, {energy}, ""});
    mesh.differences.push_back({"pressure other, 0.1 to 0.9", true, {0.0}, ""});
    return judged({mesh}, 0.01);
  };
  EXPECT_EQ(with_doubt(0.0).verdict, Verdict::Unknown);
  EXPECT_EQ(with_doubt(0.0).sides[1].reason, "a face has one point");
  EXPECT_EQ(with_doubt(1.0).verdict, Verdict::Fails) << "another quantity's miss is one";
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
  auto failing = judged({mesh_of(0.1, 0.2)}, 0.01);
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
