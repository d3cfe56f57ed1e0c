#include "cleft/convergence/curve_distance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace cleft::convergence {
namespace {

TEST(CurveDistance, IntegratesPiecewiseLinearCurvesExactly) {
  const Curve ramp{{0.0, 2.0}, {0.0, 2.0}}, tent{{0.0, 1.0, 2.0}, {0.0, 2.0, 2.0}};
  const auto d = distance(tent, ramp, {0.0, 2.0});
  EXPECT_NEAR(d.l2, std::sqrt(2.0 / 3.0), 1e-15);  // the difference is a tent of height 1
  EXPECT_NEAR(d.l2_relative, std::sqrt(2.0 / 3.0) / std::sqrt(8.0 / 3.0), 1e-15);
  EXPECT_NEAR(d.largest, 1.0, 1e-15);
  EXPECT_NEAR(d.largest_relative, 0.5, 1e-15);
}

TEST(CurveDistance, TakesPointsInAnyOrderAndLeavesOutWhatIsNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Curve a{{2.0, 0.0, 1.0}, {4.0, 0.0, nan}}, b{{0.0, 2.0}, {0.0, 4.0}};
  EXPECT_EQ(distance(a, b, {0.0, 2.0}).largest, 0.0);
}

TEST(CurveDistance, CountsAnIntervalOnly) {
  const Curve a{{0.0, 0.9, 1.1, 2.0}, {5.0, 5.0, 1.0, 1.0}}, b{{0.0, 2.0}, {1.0, 1.0}};
  EXPECT_NEAR(distance(a, b, {1.5, 2.0}).l2, 0.0, 1e-15);
  EXPECT_GT(distance(a, b, {0.5, 2.0}).l2, 1.0);
}

TEST(CurveDistance, KnowsWhereBothAreGiven) {
  const auto range = common_range({{0.0, 2.0}, {1.0, 1.0}}, {{1.0, 3.0}, {1.0, 1.0}});
  ASSERT_TRUE(range);
  EXPECT_EQ((*range)[0], 1.0);
  EXPECT_EQ((*range)[1], 2.0);
  EXPECT_FALSE(common_range({{0.0, 1.0}, {1.0, 1.0}}, {{2.0, 3.0}, {1.0, 1.0}}));
  EXPECT_THROW(distance({}, {{0.0}, {1.0}}, {0.0, 1.0}), std::invalid_argument);
  EXPECT_THROW(distance({{0.0}, {1.0}}, {{0.0}, {1.0}}, {1.0, 1.0}), std::invalid_argument);
}

}  // namespace
}  // namespace cleft::convergence
