#include "cleft/geometry/segment_grid.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>

namespace cleft::geometry {
namespace {

bool boxes_meet(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  for (int k = 0; k < 2; ++k) {
    if (std::max(a[k], b[k]) < std::min(c[k], d[k]) || std::max(c[k], d[k]) < std::min(a[k], b[k])) return false;
  }
  return true;
}

std::set<Index> visited(const SegmentGrid& grid, const Vec2& a, const Vec2& b) {
  std::set<Index> found;
  grid.near(a, b, [&](Index k) { found.insert(k); });
  return found;
}

// Lengths over ten decades, clusters far apart, points, and axis-parallel segments.
RC_GTEST_PROP(SegmentGrid, FindsAllThatBruteForceFinds, ()) {
  std::mt19937 random(*rc::gen::arbitrary<unsigned>());
  std::uniform_real_distribution<double> unit(-1, 1);
  const int count = *rc::gen::inRange(0, 60);
  const double spread = *rc::gen::element(0.0, 1.0, 1e6);
  const auto segment = [&](double far) {
    const Vec2 a = far * Vec2(std::round(unit(random)), std::round(unit(random))) + Vec2(unit(random), unit(random));
    const double length = std::pow(10.0, 5 * unit(random) - 5);
    Vec2 along = length * Vec2(unit(random), unit(random));
    if (random() % 4 == 0) along[static_cast<int>(random() % 2)] = 0;
    if (random() % 8 == 0) along.setZero();
    return std::pair<Vec2, Vec2>(a, a + along);
  };
  SegmentGrid grid;
  for (int rebuild = 0; rebuild < 2; ++rebuild) {
    std::vector<Vec2> starts, ends;
    for (int k = 0; k < count / (rebuild + 1); ++k) {
      const auto [a, b] = segment(spread);
      starts.push_back(a);
      ends.push_back(b);
    }
    grid.build(starts, ends);
    for (int q = 0; q < 10; ++q) {
      const auto [a, b] = segment(spread);
      const auto found = visited(grid, a, b);
      for (std::size_t k = 0; k < starts.size(); ++k) {
        if (boxes_meet(starts[k], ends[k], a, b)) RC_ASSERT(found.contains(static_cast<Index>(k)));
      }
      for (const Index k : found) RC_ASSERT(k >= 0 && static_cast<std::size_t>(k) < starts.size());
    }
  }
}

TEST(SegmentGrid, EmptyFindsNothing) {
  SegmentGrid grid;
  EXPECT_TRUE(visited(grid, {0, 0}, {1, 1}).empty());
  grid.build({}, {});
  EXPECT_TRUE(visited(grid, {0, 0}, {1, 1}).empty());
}

TEST(SegmentGrid, FindsCoincidentPoints) {
  const std::vector<Vec2> points(5, Vec2(2, 3));
  SegmentGrid grid;
  grid.build(points, points);
  EXPECT_EQ(visited(grid, {2, 3}, {2, 3}).size(), 5U);
  EXPECT_TRUE(visited(grid, {4, 4}, {5, 5}).empty());
}

TEST(SegmentGrid, QueryVisitsFewOnALongCurve) {
  std::vector<Vec2> starts, ends;
  for (int k = 0; k < 10000; ++k) {
    starts.emplace_back(k, k);
    ends.emplace_back(k + 1, k + 1);
  }
  SegmentGrid grid;
  grid.build(starts, ends);
  int visits = 0;
  grid.near({5000.2, 5000.3}, {5000.4, 5000.6}, [&](Index) { ++visits; });
  EXPECT_LT(visits, 50);
}

TEST(SegmentGrid, SurvivesNumbersThatAreNotFinite) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN(), kInf = std::numeric_limits<double>::infinity();
  const std::vector<Vec2> starts{{0, 0}, {1, 1}}, ends{{kNan, 1}, {kInf, 2}};
  SegmentGrid grid;
  grid.build(starts, ends);
  visited(grid, {0, 0}, {kInf, kNan});
  const std::vector<Vec2> a{{0, 0}}, b{{1, 1}};
  grid.build(a, b);
  EXPECT_EQ(visited(grid, {-kInf, -kInf}, {kInf, kInf}).size(), 1U);
}

}  // namespace
}  // namespace cleft::geometry
