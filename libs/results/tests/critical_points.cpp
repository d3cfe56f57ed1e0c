// Limit points and bifurcations, from the columns of a history.
#include "cleft/results/critical_points.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace cleft::results {
namespace {

using Kind = CriticalPoint::Kind;
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

std::vector<CriticalPoint> points_of(const std::vector<double>& loads, const std::vector<double>& signs) {
  CsvTable table{{"step", "load", "determinant_sign"}, {}};
  for (std::size_t k = 0; k < loads.size(); ++k)
    table.rows.push_back({fmt::format("{}", k + 1), fmt::format("{}", loads[k]), fmt::format("{}", signs[k])});
  return critical_points(table);
}

TEST(CriticalPoints, AreWhereTheLoadTurns) {
  const auto points = points_of({0.1, 0.3, 0.35, 0.2, 0.15, 0.4, 1.0}, {1, 1, 1, -1, -1, 1, 1});
  ASSERT_EQ(points.size(), 2u);
  EXPECT_EQ(points[0].kind, Kind::Maximum);
  EXPECT_EQ(points[0].load, 0.35);
  EXPECT_EQ(points[0].step, 3);
  EXPECT_EQ(points[1].kind, Kind::Minimum);
  EXPECT_EQ(points[1].load, 0.15);
  EXPECT_EQ(points[1].step, 5);
}

// The sign belongs to the last factors of an increment, which may be those of its begin.
TEST(CriticalPoints, AreNoBifurcationsWhereTheSignChangesAnIncrementEarlyOrLate) {
  for (const auto& signs : {std::vector<double>{1, 1, -1, -1, -1}, {1, 1, 1, -1, -1}, {1, 1, 1, 1, -1}}) {
    const auto points = points_of({0.1, 0.2, 0.3, 0.25, 0.2}, signs);
    ASSERT_EQ(points.size(), 1u);
    EXPECT_EQ(points[0].kind, Kind::Maximum);
  }
}

TEST(CriticalPoints, AreBifurcationsWhereTheSignChangesAndTheLoadGoesOn) {
  const auto points = points_of({0.1, 0.2, 0.3, 0.4, 0.5, 0.6}, {1, 1, kUnknown, -1, -1, 1});
  ASSERT_EQ(points.size(), 2u);
  for (const auto& point : points) EXPECT_EQ(point.kind, Kind::Bifurcation);
  EXPECT_EQ(points[0].before, 0.2) << "the row between tells nothing";
  EXPECT_EQ(points[0].load, 0.4);
  EXPECT_EQ(points[0].step, 4);
  EXPECT_EQ(points[1].before, 0.5);
}

TEST(CriticalPoints, BeginWithTheBodyAtRestWhichIsStable) {
  const auto points = points_of({0.1, 0.2, 0.3}, {-1, -1, 1});
  ASSERT_EQ(points.size(), 2u);
  EXPECT_EQ(points[0].before, 0.0);
  EXPECT_EQ(points[0].load, 0.1);
  EXPECT_EQ(points_of({0.1, 0.2}, {kUnknown, -1}).at(0).load, 0.2);
}

TEST(CriticalPoints, AreNoneOnAPlateauWhoseLoadIsOnlyRounded) {
  EXPECT_TRUE(points_of({0.3, 0.5, 0.5 - 1e-9, 0.5 + 1e-9, 0.5 - 2e-9}, {1, 1, 1, 1, 1}).empty());
  EXPECT_TRUE(points_of({}, {}).empty());
}

}  // namespace
}  // namespace cleft::results
