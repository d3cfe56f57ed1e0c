#include "cleft/geometry/crack.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cleft/support/error.hpp"

namespace cleft::geometry {
namespace {

TEST(SineCurve, StaysWithinItsTolerance) {
  for (const double tolerance : {1e-2, 1e-4}) {
    const Vec2 start(0.2, 0.1), end(1.4, 0.9);
    const double length = (end - start).norm(), amplitude = 0.15, periods = 2.3;
    const auto points = sine_curve(start, end, amplitude, periods, tolerance);
    const Vec2 along = (end - start) / length;
    double worst = 0.0;
    for (std::size_t k = 0; k + 1 < points.size(); ++k) {
      for (double f = 0.0; f <= 1.0; f += 0.05) {
        const Vec2 p = points[k] + f * (points[k + 1] - points[k]) - start;
        const double exact = amplitude * std::sin(2 * std::numbers::pi * periods * p.dot(along) / length);
        worst = std::max(worst, std::abs(cross(along, p) - exact));
      }
    }
    EXPECT_LE(worst, tolerance * (1 + 1e-9));
    EXPECT_GT(worst, 0.1 * tolerance);
  }
}

TEST(SineCurve, HoldsCrestsAndZeros) {
  const auto points = sine_curve({0, 0}, {8, 0}, 0.5, 2.0, 1e-3);
  const auto holds = [&](const Vec2& p) { return std::find(points.begin(), points.end(), p) != points.end(); };
  for (const Vec2& p : {Vec2(0, 0), Vec2(1, 0.5), Vec2(2, 0), Vec2(3, -0.5), Vec2(4, 0), Vec2(8, 0)})
    EXPECT_TRUE(holds(p)) << p.transpose();
  EXPECT_EQ(points.front(), Vec2(0, 0));
  EXPECT_EQ(points.back(), Vec2(8, 0));
}

TEST(SineCurve, FirstWaveIsOnTheLeft) {
  const auto points = sine_curve({0, 0}, {0, 1}, 0.1, 1.0, 1e-3);
  EXPECT_LT(points[1].x(), 0.0);
}

TEST(SineCurve, IsAStraightLineWithoutAmplitude) { EXPECT_EQ(sine_curve({0, 0}, {1, 0}, 0.0, 3.0, 1e-3).size(), 2U); }

TEST(SineCurve, RefusesWhatItCannotSample) {
  EXPECT_THROW(sine_curve({0, 0}, {0, 0}, 1, 1, 1e-3), InputError);
  EXPECT_THROW(sine_curve({0, 0}, {1, 0}, 1, 1, 0), InputError);
  EXPECT_THROW(sine_curve({0, 0}, {1, 0}, 1, -1, 1e-3), InputError);
  EXPECT_THROW(sine_curve({0, 0}, {1, 0}, 1, 1, 1e-30), InputError);
}

}  // namespace
}  // namespace cleft::geometry
