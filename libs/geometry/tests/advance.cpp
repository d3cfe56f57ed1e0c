#include "cleft/geometry/advance.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "cleft/geometry/cut.hpp"
#include "cleft/geometry/delaunay.hpp"

namespace cleft::geometry {
namespace {

TEST(Reach, EndsWhereTheBodyDoes) {
  const Mesh mesh = structured_mesh({0, 0, 2, 1}, {4, 3}, Diagonal::Alternating);
  EXPECT_EQ(reach(mesh, {0.5, 0.5}, {1.7, 0.6}), Vec2(1.7, 0.6));
  EXPECT_EQ(reach(mesh, {0.5, 0.5}, {2.0, 0.5}), Vec2(2.0, 0.5));
  EXPECT_LT((reach(mesh, {0.5, 0.5}, {4.5, 0.5}) - Vec2(2.0, 0.5)).norm(), 1e-14);
  EXPECT_LT((reach(mesh, {1.5, 0.5}, {2.5, 1.5}) - Vec2(2.0, 1.0)).norm(), 1e-14);  // by a corner
}

TEST(Reach, EndsAtAHoleEvenIfTheBodyGoesOnBehindIt) {
  Outline outline = box_outline({0, 0, 3, 1});
  outline.holes = {{{{1.2, 0.3}, {1.8, 0.3}, {1.8, 0.7}, {1.2, 0.7}}, {"hole", "hole", "hole", "hole"}}};
  const Mesh mesh = delaunay_mesh(outline, {0.3, 0.25, {}});
  EXPECT_LT((reach(mesh, {0.4, 0.5}, {2.6, 0.5}) - Vec2(1.2, 0.5)).norm(), 1e-13);
}

TEST(Extended, LeavesOldArcLengthsAsTheyWere) {
  const Mesh mesh = structured_mesh({0, 0, 1, 1}, {7, 7}, Diagonal::Left);
  const Crack crack{"c", {{0.33, 0.41}, {0.68, 0.52}}};
  const Crack longer = extended(extended(crack, 0, {0.2, 0.3}), 1, {0.7, 0.7});
  EXPECT_NEAR(longer.s_first, -std::hypot(0.13, 0.11), 1e-15);
  EXPECT_EQ(longer.points.front(), Vec2(0.2, 0.3));
  EXPECT_EQ(longer.points.back(), Vec2(0.7, 0.7));
  const auto before = cut(mesh, {crack}), after = cut(mesh, {longer});
  const double length = (crack.points[1] - crack.points[0]).norm();
  int same = 0;
  for (const auto& old : before.segments)
    for (const auto& now : after.segments)
      if (old.start == now.start && old.end == now.end) {
        EXPECT_NEAR(old.s_start, now.s_start, 1e-15);
        EXPECT_NEAR(old.s_end, now.s_end, 1e-15);
        ++same;
      }
  EXPECT_GE(same, static_cast<int>(before.segments.size()) - 3);
  for (const auto& now : after.segments) EXPECT_TRUE(now.start != crack.points[0] || std::abs(now.s_start) < 1e-15);
  EXPECT_NEAR(after.cracks[0].ends[1].s, length + std::hypot(0.02, 0.18), 0.2);
  const Tip tip = tip_of(longer, 0);
  EXPECT_LT((tip.ahead - Vec2(-0.13, -0.11).normalized()).norm(), 1e-15);
}

}  // namespace
}  // namespace cleft::geometry
