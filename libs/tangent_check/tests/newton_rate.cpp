#include "cleft/tangent_check/newton_rate.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace cleft::tangent_check {
namespace {

IncrementRate rate(double order, bool at_least = false) {
  IncrementRate r;
  r.order = solve::ConvergenceOrder{order, at_least};
  return r;
}

TEST(JudgeRates, CountsOrdersAndBoundsThatReachWhatIsRequired) {
  std::vector<IncrementRate> rates(9, rate(2.0));
  rates.push_back(rate(1.6));
  rates.push_back(rate(2.5, true));
  rates.push_back(rate(1.7, true));
  rates.push_back({});
  const auto v = judge(rates, {});
  EXPECT_EQ(v.increments, 13u);
  EXPECT_EQ(v.judged, 11u);
  EXPECT_EQ(v.reach, 10u);
  EXPECT_EQ(v.missed.size(), 1u);
  EXPECT_EQ(v.unjudged.size(), 2u);
  EXPECT_EQ(v.bounds, 1u);
  EXPECT_EQ(v.lowest(), 1.6);
  EXPECT_EQ(v.orders[4], 2.5);
  EXPECT_TRUE(v.holds);
}

// What is known of the order goes first; two corrections only count where it leaves the question open.
TEST(JudgeRates, TakesTwoCorrectionsForEnoughOnly) {
  auto known = rate(1.6), bound = rate(1.2, true), none = IncrementRate{}, slow = IncrementRate{};
  known.at_unit_scale = bound.at_unit_scale = none.at_unit_scale = 2.0;
  slow.at_unit_scale = 1.4;
  const auto v = judge({rate(2.0), known, bound, none, slow}, {.share = 0.5});
  EXPECT_EQ(v.judged, 2u);
  EXPECT_EQ(v.scaled, 2u);
  EXPECT_EQ(v.missed.size(), 1u);
  EXPECT_EQ(v.unjudged.size(), 1u);
  EXPECT_TRUE(v.enough);
  EXPECT_TRUE(v.holds);

  std::vector<IncrementRate> many(57, none);
  many.insert(many.end(), 4, known);
  EXPECT_TRUE(judge(many, {}).enough);
  EXPECT_FALSE(judge(many, {}).holds) << "they do not outweigh what misses";
  EXPECT_FALSE(judge(std::vector(9, none), {}).holds) << "one order at least must be known";
}

TEST(JudgeRates, GivesTheQuartilesOfTheOrders) {
  const auto v = judge({rate(2.4), rate(1.8), rate(2.0), rate(1.9), rate(2.1), rate(1.0, true)}, {});
  EXPECT_EQ(v.orders, (std::array{1.8, 1.9, 2.0, 2.1, 2.4}));
  EXPECT_EQ(judge({rate(2.1)}, {}).orders, (std::array{2.1, 2.1, 2.1, 2.1, 2.1}));
}

TEST(JudgeRates, FailsOnTooFewThatReachOneTooLowAndTooFewThatCanBeJudged) {
  std::vector<IncrementRate> few(8, rate(2.0));
  few.insert(few.end(), 2, rate(1.7));
  EXPECT_FALSE(judge(few, {}).holds);
  EXPECT_TRUE(judge(few, {.share = 0.8}).holds);
  std::vector<IncrementRate> low(20, rate(2.0));
  low.push_back(rate(1.4));
  EXPECT_FALSE(judge(low, {}).holds);
  EXPECT_TRUE(judge(low, {.least = 1.3}).holds);
  std::vector<IncrementRate> unknown(5, rate(2.0));
  unknown.resize(11);
  EXPECT_FALSE(judge(unknown, {}).enough);
  EXPECT_FALSE(judge(unknown, {}).holds);
  EXPECT_FALSE(judge({}, {}).holds);
}

TEST(NewtonRates, AreReadIncrementByIncrement) {
  const std::string folder = testing::TempDir() + "cleft_newton_rates";
  std::filesystem::create_directories(folder);
  const std::string header =
      "step,load,iteration,residual,correction,energy,partner_changes,status_changes,factor_seconds,assembly_seconds,"
      "rounding,gradient,kept\n";
  std::ofstream(folder + "/newton.csv")
      << header
      << "1,0.1,1,1e-2,1e-2,1,0,0,0,0,1e-13,1e-2,0\n1,0.1,2,1e-4,1e-4,1,0,0,0,0,1e-13,1e-4,0\n"
         "1,0.1,3,1e-8,1e-8,1,0,0,0,0,1e-13,1e-8,1\n1,0.1,4,1e-14,0,0,0,0,0,0,1e-13,0,0\n"
         "2,0.2,1,1e-2,1e-2,1,0,2,0,0,1e-13,1e-2,0\n2,0.2,2,1e-14,0,0,0,0,0,0,1e-13,0,0\n";
  const auto rates = newton_rates(folder);
  ASSERT_EQ(rates.size(), 2u);
  EXPECT_EQ(rates[0].iterations.size(), 4u);
  EXPECT_NEAR(rates[0].order->order, 2.0, 1e-12);
  EXPECT_EQ(rates[1].load, 0.2);
  EXPECT_EQ(rates[1].iterations[0].status_changes, 2);
  EXPECT_FALSE(rates[1].order);
  EXPECT_THROW(newton_rates(folder + "/none"), std::runtime_error);
  std::ofstream(folder + "/newton.csv") << "step,load\n";
  EXPECT_THROW(newton_rates(folder), std::runtime_error);
}

}  // namespace
}  // namespace cleft::tangent_check
