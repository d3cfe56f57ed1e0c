#include "cleft/tangent_check/newton_rate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace cleft::tangent_check {
namespace {

// Corrections of these gradients, which all other sizes follow, from residuals far above rounding; then what is left.
std::vector<solve::Iteration> iterations(const std::vector<double>& gradients, double left = 1e-14) {
  std::vector<solve::Iteration> out;
  for (const double g : gradients) {
    auto& it = out.emplace_back();
    it.residual = it.correction = it.gradient = g;
    it.energy = g * g;
    it.rounding = 1e-13;
  }
  out.emplace_back().residual = left;
  out.back().rounding = 1e-13;
  return out;
}

Finding finding_of(const std::vector<solve::Iteration>& its) { return find(observe(its), {}); }
Finding finding(const std::vector<double>& gradients, double left = 1e-14) {
  return finding_of(iterations(gradients, left));
}

TEST(Finding, IsTheOrderWhereThreeCorrectionsShowIt) {
  EXPECT_EQ(finding({1e-1, 1e-2, 1e-4, 1e-8}), Finding::Order);
  EXPECT_EQ(finding({1e-1, 1e-2, 1e-3, 1e-4, 1e-5}, 1e-6), Finding::Missed);
  EXPECT_NEAR(*observe(iterations({1e-1, 1e-2, 1e-3, 1e-4, 1e-5}, 1e-6)).order, 1.0, 1e-12);
}

// As in a yielding block, whose error sits elsewhere after the first correction: 1.34 by the gradients.
TEST(Finding, TakesTheBestOfCorrectionResidualAndEnergy) {
  for (double solve::Iteration::*size : {&solve::Iteration::residual, &solve::Iteration::correction}) {
    auto its = iterations({1e-2, 1e-5, 1e-9}, 1e-11);
    its[2].*size = 1e-8 * 1e-3;
    EXPECT_EQ(finding_of(its), Finding::Order);
  }
  auto its = iterations({1e-2, 1e-5, 1e-9}, 1e-11);
  its[2].energy = 1e-22;
  EXPECT_EQ(finding_of(its), Finding::Order);
}

// Three numbers give 1.67 where g+/g^2 is 1 and then 10, which a linear iteration would have let grow to 1000.
TEST(Finding, IsTheConstantWhereItIsBounded) {
  EXPECT_EQ(finding({1e-3, 1e-6, 1e-11}, 1e-12), Finding::Constant);
  EXPECT_EQ(finding({1e-5, 2e-7, 3e-10}, 1e-12), Finding::Constant) << "2000 and 7500";
  EXPECT_EQ(finding({1e-3, 1e-6, 1e-9}, 1e-12), Finding::Missed) << "1 and 1000";
  EXPECT_EQ(finding({1e-1, 3e-2, 9e-3, 2.7e-3}, 8e-4), Finding::Missed) << "below 40, but the ratio stays";
}

// g+ = C g^2 + q g with the relative error q of the tangent, once three corrections lie where q is more than C g.
TEST(Finding, MissesWhateverErrorOfTheTangentThreeCorrectionsShow) {
  int cases = 0;
  for (const double q : {0.5, 0.1, 1e-2, 1e-3, 1e-4, 2e-5})
    for (const double C : {0.01, 1.0, 100.0})
      for (const double start : {1e-2, 1e-3, 1e-4}) {
        std::vector<double> g{start};
        while (g.back() > 1e-13 && g.size() < 60) g.push_back(C * g.back() * g.back() + q * g.back());
        if (std::ranges::count_if(g, [&](double of) { return of > 1e-13 && C * of < q; }) < 3) continue;
        EXPECT_EQ(finding(g), Finding::Missed) << "q " << q << " C " << C << " start " << start;
        ++cases;
      }
  EXPECT_GT(cases, 30);
}

TEST(Finding, IsLinearWhereOneStepLeavesNothing) {
  EXPECT_EQ(finding({1e-2, 1e-16}), Finding::Linear);
  EXPECT_EQ(finding({1e-2}), Finding::Linear) << "by the residual";
  EXPECT_EQ(finding({1e-2, 1e-7}, 1e-9), Finding::UnitScale);
  EXPECT_EQ(finding({1e-2, 1e-4, 2e-6}, 4e-8), Finding::Missed);
}

TEST(Finding, IsThatNothingShowsWhereTheIterationBeginsAtRounding) {
  EXPECT_EQ(finding({1e-14}), Finding::AtRounding);
  EXPECT_EQ(finding({1e-11, 1e-14}), Finding::AtRounding);
  EXPECT_EQ(finding({1e-6, 1e-8}, 1e-10), Finding::Unknown) << "two corrections, not small enough for the order";
}

TEST(Finding, BeginsAnewWhereContactOrFlowSwitches) {
  for (int solve::Iteration::*switches :
       {&solve::Iteration::partner_changes, &solve::Iteration::status_changes, &solve::Iteration::flow_changes}) {
    auto its = iterations({1e-1, 5e-2, 2e-2, 1e-2, 1e-4, 1e-8});
    its[3].*switches = 1;
    EXPECT_EQ(observe(its).corrections, 3u);
    EXPECT_EQ(finding_of(its), Finding::Order);
    its[5].*switches = 1;
    EXPECT_NE(finding_of(its), Finding::Order) << "too late to show it";
  }
}

TEST(Finding, IsMissedWhereTheIterationHardlyMoves) {
  EXPECT_EQ(finding({1e-2, 8e-3, 7e-3, 6e-3, 5e-3, 4e-3}, 3e-3), Finding::Missed);
}

IncrementRate increment(const std::vector<double>& gradients, double left = 1e-14) {
  IncrementRate out;
  out.iterations = iterations(gradients, left);
  out.rate = observe(out.iterations);
  return out;
}
IncrementRate quadratic() { return increment({1e-1, 1e-2, 1e-4, 1e-8}); }
IncrementRate linear() { return increment({1e-2, 1e-4, 1e-6, 1e-8, 1e-10}, 1e-12); }
IncrementRate nearly() { return increment({1e-2, 1e-4, 1.6e-7}, 1e-9); }  // order 1.4
IncrementRate below() { return increment({1e-4, 1e-5, 2e-7}, 1e-8); }     // order 1.7, the constant grows twofold
IncrementRate failed(IncrementRate of) {
  of.failed = true;
  return of;
}

TEST(JudgeRates, HoldsOnQuadraticAndLinearProblems) {
  EXPECT_EQ(judge(std::vector(5, quadratic()), {}).answer, RateAnswer::Holds);
  const auto v = judge(std::vector(5, increment({1e-2, 1e-16})), {});
  EXPECT_EQ(v.answer, RateAnswer::Holds);
  EXPECT_EQ(v.of(Finding::Linear), 5u);
}

TEST(JudgeRates, MissesOnOneTooLowAndOnTooManyBelow) {
  std::vector<IncrementRate> rates(20, quadratic());
  rates.push_back(nearly());
  EXPECT_EQ(judge(rates, {}).answer, RateAnswer::Misses);
  EXPECT_EQ(judge(rates, {.least = 1.3}).answer, RateAnswer::Holds);
  rates.assign(5, quadratic());
  rates.insert(rates.end(), 2, below());
  EXPECT_EQ(judge(rates, {}).answer, RateAnswer::Misses);
  EXPECT_EQ(judge(rates, {.share = 0.7}).answer, RateAnswer::Holds);
  rates.pop_back();
  const auto v = judge(rates, {});
  EXPECT_EQ(v.answer, RateAnswer::Unknown) << "one of six by little";
  EXPECT_NE(v.reason.find("one of 6"), std::string::npos) << v.reason;
}

TEST(JudgeRates, CannotTellWhereTooFewShowAnything) {
  EXPECT_EQ(judge({}, {}).answer, RateAnswer::Unknown);
  EXPECT_EQ(judge(std::vector(9, increment({1e-2, 1e-5}, 1e-9)), {}).answer, RateAnswer::Unknown)
      << "one order at least must be known";
  std::vector<IncrementRate> rates(5, quadratic());
  rates.resize(11, increment({1e-4, 1e-6}, 1e-9));
  EXPECT_EQ(judge(rates, {}).answer, RateAnswer::Unknown);
  rates.assign(5, quadratic());
  rates.resize(60, increment({1e-11, 1e-14}));
  EXPECT_EQ(judge(rates, {}).answer, RateAnswer::Holds) << "what begins at rounding is no evidence either way";
}

// Attempts fail where contact does not settle or there is no solution; neither is an error of the tangent.
TEST(JudgeRates, JudgesFailedAttemptsOnlyWhereTheyAreLinearForSure) {
  std::vector<IncrementRate> rates(5, quadratic());
  rates.push_back(failed(increment({1e-1, 2e-1, 1e-1, 3e-1}, 1e-1)));
  rates.push_back(quadratic());
  EXPECT_EQ(judge(rates, {}).answer, RateAnswer::Holds);
  EXPECT_EQ(judge(rates, {}).failed, 1u);
  rates.push_back(failed(increment({1e-1, 5e-2, 2.5e-2, 1.2e-2, 6e-3, 3e-3}, 2e-3)));
  const auto v = judge(rates, {});
  EXPECT_EQ(v.answer, RateAnswer::Unknown) << "as where the tangent is singular";
  EXPECT_TRUE(v.ends_in_failure);
  rates.push_back(failed(increment({1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6}, 1e-7)));
  EXPECT_EQ(judge(rates, {}).answer, RateAnswer::Misses);
}

TEST(JudgeRates, GivesOrdersAndTheSharpestRatio) {
  const auto v = judge({quadratic(), below(), quadratic()}, {});
  EXPECT_NEAR(v.orders.front(), 1.699, 1e-3);
  EXPECT_NEAR(v.orders.back(), 2.0, 1e-12);
  EXPECT_NEAR(*v.sharpest, 1e-6, 1e-12);
}

TEST(ClearlyLinear, NeedsFiveIncrementsInARow) {
  std::vector<IncrementRate> rates(4, linear());
  EXPECT_FALSE(is_clearly_linear(rates, {}));
  rates.push_back(quadratic());
  rates.push_back(linear());
  EXPECT_FALSE(is_clearly_linear(rates, {}));
  rates.insert(rates.end(), 4, linear());
  EXPECT_TRUE(is_clearly_linear(rates, {}));
}

TEST(NewtonRates, AreReadAttemptByAttempt) {
  const std::string folder = testing::TempDir() + "cleft_newton_rates";
  std::filesystem::create_directories(folder);
  const std::string header =
      "step,load,iteration,residual,correction,energy,partner_changes,status_changes,factor_seconds,assembly_seconds,"
      "rounding,gradient,chatters,kept,flow_changes,largest,largest_X,largest_Y,attempt,failed\n";
  std::ofstream(folder + "/newton.csv")
      << header
      << "1,0.1,1,1e-2,1e-2,1,0,0,0,0,1e-13,1e-2,0,0,0,node,0,0,1,0\n1,0.1,2,1e-4,1e-4,1,0,0,0,0,1e-13,1e-4,0,0,0,"
         "contact,3,4,1,0\n1,0.1,3,1e-8,1e-8,1,0,0,0,0,1e-13,1e-8,0,1,0,flow,0,0,1,0\n"
         "1,0.1,4,1e-14,0,0,0,0,0,0,1e-13,0,0,0,0,none,0,0,1,0\n"
         "2,0.3,1,1e-2,1e-2,1,0,0,0,0,1e-13,1e-2,0,0,0,node,0,0,1,1\n"
         "2,0.2,1,1e-2,1e-2,1,0,2,0,0,1e-13,1e-2,0,0,7,node,0,0,2,0\n"
         "2,0.2,2,1e-14,0,0,0,0,0,0,1e-13,0,0,0,0,none,0,0,2,0\n";
  const auto rates = newton_rates(folder);
  ASSERT_EQ(rates.size(), 3u);
  EXPECT_EQ(rates[0].iterations.size(), 4u);
  EXPECT_NEAR(*rates[0].rate.order, 2.0, 1e-12);
  EXPECT_EQ(rates[0].iterations[1].largest.at, solve::LargestResidual::At::Contact);
  EXPECT_EQ(rates[0].iterations[1].largest.place, Vec2(3.0, 4.0));
  EXPECT_TRUE(rates[1].failed);
  EXPECT_EQ(rates[1].step, 2);
  EXPECT_EQ(rates[1].load, 0.3);
  EXPECT_FALSE(rates[2].failed);
  EXPECT_EQ(rates[2].load, 0.2);
  EXPECT_EQ(rates[2].iterations[0].flow_changes, 7);
  EXPECT_FALSE(rates[2].rate.order);
  EXPECT_THROW(newton_rates(folder + "/none"), std::runtime_error);
  std::ofstream(folder + "/newton.csv") << "step,load\n";
  EXPECT_THROW(newton_rates(folder), std::runtime_error);
}

}  // namespace
}  // namespace cleft::tangent_check
