// The order that the corrections of an iteration show.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "cleft/solve/newton.hpp"

namespace cleft::solve {
namespace {

// Residual, correction, changes of contact; rounding leaves 1e-13.
std::vector<Iteration> iterations(const std::vector<std::array<double, 3>>& rows) {
  std::vector<Iteration> out;
  for (const auto& [residual, correction, changes] : rows) {
    auto& it = out.emplace_back();
    it.residual = residual;
    it.correction = it.gradient = correction;
    it.status_changes = static_cast<int>(changes);
    it.rounding = 1e-13;
  }
  return out;
}

TEST(ConvergenceOrder, ComesFromTheLastThreeCorrectionsAboveRounding) {
  const auto quadratic = convergence_order(iterations(
      {{1e-1, 1e-1, 0}, {1e-2, 1e-2, 0}, {1e-4, 1e-4, 0}, {1e-8, 1e-8, 0}, {1e-14, 1e-15, 0}, {1e-14, 0, 0}}));
  ASSERT_TRUE(quadratic);
  EXPECT_NEAR(quadratic->order, 2.0, 1e-12);
  EXPECT_FALSE(quadratic->at_least);
  EXPECT_NEAR(convergence_order(iterations({{1, 1, 0}, {1, 1e-2, 0}, {1, 1e-4, 0}, {1, 1e-6, 0}}))->order, 1.0, 1e-12);
}

TEST(ConvergenceOrder, IsABoundWhereTheThirdCorrectionIsRounding) {
  const auto bound =
      convergence_order(iterations({{1e-2, 1e-3, 0}, {1e-6, 1e-7, 0}, {5e-14, 1e-14, 0}, {4e-14, 1e-14, 0}}));
  ASSERT_TRUE(bound);
  EXPECT_NEAR(bound->order, 7.0 / 4.0, 1e-12);
  EXPECT_TRUE(bound->at_least);
}

TEST(ConvergenceOrder, JudgesByTheLargestGradientAndBoundsByTheBetterOfBothNorms) {
  auto its = iterations({{1e-2, 1e-2, 0}, {1e-5, 1e-5, 0}, {1e-9, 1e-9, 0}, {1e-14, 0, 0}});
  for (auto [k, gradient] : {std::pair{0, 1e-1}, {1, 1e-3}, {2, 1e-7}}) its[k].gradient = gradient;
  EXPECT_NEAR(convergence_order(its)->order, 4.0 / 2.0, 1e-12);
  its[2].residual = 5e-14;
  const auto bound = convergence_order(its);
  EXPECT_TRUE(bound->at_least);
  EXPECT_NEAR(bound->order, 4.0 / 2.0, 1e-12) << "in displacements it would be 4/3";
}

TEST(ConvergenceOrder, ForgetsAllButTheLastThree) {
  EXPECT_NEAR(convergence_order(iterations({{1, 1, 0}, {1, 0.5, 0}, {1, 1e-2, 0}, {1, 2e-6, 0}}))->order,
              std::log(5000.0) / std::log(50.0), 1e-12);
}

TEST(ConvergenceOrder, TakesACorrectionThatTheNextOneUndercutsTenfoldForNoRounding) {
  const std::vector<std::array<double, 3>> start{{1e-2, 1e-2, 0}, {1e-6, 1e-5, 0}, {5e-14, 1e-11, 0}};
  for (const auto& [next, rounded] : {std::pair{5e-13, false}, {5e-12, true}}) {
    auto rows = start;
    rows.push_back({5e-14, next, 0});
    const auto order = convergence_order(iterations(rows));
    EXPECT_NEAR(order->order, 2.0, 1e-12);
    EXPECT_EQ(order->at_least, rounded) << "next " << next;
  }
}

TEST(ConvergenceOrder, TakesTheHigherOfTwoBounds) {
  auto its = iterations({{1e-2, 1e-2, 0}, {1e-6, 1e-5, 0}, {5e-14, 1e-11, 0}, {5e-14, 5e-12, 0}});
  its[2].gradient = 1e-10;  // 5/3 in gradients
  its[3].gradient = 5e-11;
  EXPECT_NEAR(convergence_order(its)->order, 2.0, 1e-12);
  its[2].gradient = 1e-12;  // 7/3
  its[3].gradient = 5e-13;
  EXPECT_NEAR(convergence_order(its)->order, 7.0 / 3.0, 1e-12);
}

// Halved steps leave the correction as it was but for a little, and then a full one removes it.
TEST(ConvergenceOrder, IsNotThatOfDampedSteps) {
  EXPECT_FALSE(
      convergence_order(iterations({{4e-3, 1.8662e-4, 0}, {2e-3, 1.8659e-4, 0}, {1e-6, 4.4e-8, 0}, {4e-14, 0, 0}})));
}

TEST(ConvergenceOrder, StartsWhereTheContactHasSettled) {
  const auto late = iterations({{1, 1, 0}, {1, 0.5, 0}, {1e-2, 1e-2, 3}, {1e-3, 1e-4, 0}, {1e-6, 1e-8, 0}});
  EXPECT_NEAR(convergence_order(late)->order, 2.0, 1e-12);
  EXPECT_FALSE(convergence_order(iterations({{1, 1e-2, 0}, {1, 1e-4, 0}, {1, 1e-8, 1}, {1e-14, 0, 0}})));
}

TEST(ConvergenceOrder, EndsWithTheFirstCorrectionByOldFactors) {
  auto its = iterations({{1, 1e-1, 1}, {1, 1e-2, 0}, {1e-2, 1e-4, 0}, {1e-6, 1e-8, 0}, {1e-9, 1e-11, 0}});
  its[3].kept = true;  // it shows the error that a full step left; what it leaves itself is of first order
  EXPECT_NEAR(convergence_order(its)->order, 2.0, 1e-12);
  its[1].kept = true;
  EXPECT_FALSE(convergence_order(its));
  auto late = iterations({{1, 1, 0}, {1, 1e-1, 1}, {1, 1e-2, 0}, {1e-2, 1e-4, 0}});
  late[0].kept = true;  // before the contact settled
  ASSERT_TRUE(convergence_order(late));
  EXPECT_NEAR(convergence_order(late)->order, 2.0, 1e-12);
}

TEST(ConvergenceOrder, IsNotGuessed) {
  EXPECT_FALSE(convergence_order({}));
  EXPECT_FALSE(convergence_order(iterations({{1e-2, 1e-2, 0}, {1e-5, 1e-5, 0}, {1e-11, 0, 0}})));
  EXPECT_FALSE(convergence_order(iterations({{1, 1e-2, 0}, {1, 2e-2, 0}, {1, 1e-4, 0}})))
      << "the first step lost ground";
}

TEST(OrderAtUnitScale, IsThatOfTheFirstTwoCorrectionsOfTheSettledContact) {
  EXPECT_NEAR(*order_at_unit_scale(iterations({{1, 1e-2, 3}, {1e-2, 1e-3, 1}, {1e-6, 1e-6, 0}, {1e-14, 0, 0}})), 2.0,
              1e-12);
  EXPECT_NEAR(*order_at_unit_scale(iterations({{1, 1e-3, 0}, {1e-4, 1e-4, 0}, {1e-5, 1e-5, 0}})), 4.0 / 3.0, 1e-12)
      << "linear";
}

TEST(OrderAtUnitScale, IsUnknownWhereTheFirstCorrectionTellsNothing) {
  EXPECT_FALSE(order_at_unit_scale({}));
  EXPECT_FALSE(order_at_unit_scale(iterations({{1, 1e-3, 0}, {1e-14, 0, 0}}))) << "one correction";
  EXPECT_FALSE(order_at_unit_scale(iterations({{1, 0.5, 0}, {1e-1, 0.2, 0}, {1e-2, 1e-2, 0}}))) << "large";
  EXPECT_FALSE(order_at_unit_scale(iterations({{1e-2, 1e-3, 0}, {1e-1, 1e-2, 0}, {1e-2, 1e-3, 0}}))) << "grew";
  EXPECT_FALSE(order_at_unit_scale(iterations({{5e-14, 1e-12, 0}, {5e-14, 1e-15, 0}, {5e-14, 0, 0}}))) << "rounding";
}

}  // namespace
}  // namespace cleft::solve
