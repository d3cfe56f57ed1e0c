#include "study_costs.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace cleft::convergence {
namespace {

// Seconds 4^k at relative errors `first` 2^-k, of first order in h.
StudyResult halved(double first, std::size_t runs) {
  StudyResult out;
  Series s;
  for (std::size_t k = 0; k < runs; ++k) {
    StudyRun run;
    run.h = std::pow(0.5, k);
    run.unknowns = static_cast<Index>(100) << (2 * k);
    run.seconds = std::pow(4.0, k);
    out.runs.push_back(run);
    s.runs.push_back(k);
    s.error.push_back(first * run.h);
  }
  s.fit.determined = true;
  s.fit.order = 1.0;
  out.series.push_back(s);
  return out;
}

TEST(StudyCosts, SecondsForAnErrorLieBetweenTheRunsOrALittleBeyondThem) {
  const auto between = work_of(halved(0.04, 6), 0);
  ASSERT_EQ(between.size(), 2u);
  EXPECT_EQ(between[0].how, Work::How::Measured);
  EXPECT_NEAR(between[0].seconds, 16.0, 1e-9) << "1 % on the third mesh, as (error)^-2";
  EXPECT_EQ(between[1].how, Work::How::Extrapolated) << "0.125 % on the finest";
  EXPECT_NEAR(between[1].seconds, 1600.0, 1e-6);
  const auto coarse = work_of(halved(0.04, 3), 0);
  EXPECT_EQ(coarse[1].how, Work::How::OutOfReach) << "ten times finer than the finest";
  EXPECT_TRUE(std::isnan(coarse[1].seconds));
  EXPECT_EQ(work_of(halved(0.008, 6), 0)[0].how, Work::How::AtMost);
}

TEST(StudyCosts, NothingIsToldOfErrorsThatAreNotKnown) {
  StudyResult result = halved(0.04, 6);
  result.series[0].fit.determined = false;
  EXPECT_EQ(work_of(result, 0)[1].how, Work::How::OutOfReach) << "an order that is not determined leads nowhere";
  result.series[0].reference_h = 0.01;
  EXPECT_TRUE(work_of(result, 0).empty()) << "a distance from the finest mesh is no error";
  result.series[0].reference_h = 0.0;
  result.series[0].has_errors = false;
  EXPECT_TRUE(work_of(result, 0).empty());
}

TEST(StudyCosts, AreOfTheRunsThatReachedTheirEnd) {
  StudyResult result = halved(0.04, 5);
  result.runs[4].seconds = 1e9;
  result.runs[4].failure = "failed";
  result.runs[3].seconds = 128.0;  // 16 before
  const auto costs = costs_of(result.runs);
  ASSERT_EQ(costs[0].what, "seconds");
  EXPECT_EQ(costs[0].over, "unknowns");
  EXPECT_NEAR(costs[0].last_slope, 1.5, 1e-12) << "8 times the seconds for 4 times the unknowns";
  for (auto& run : result.runs) run.unknowns = 100;
  EXPECT_EQ(costs_of(result.runs)[0].over, "1/h");
}

}  // namespace
}  // namespace cleft::convergence
