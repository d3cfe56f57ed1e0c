#include "cleft/geometry/disc.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "cleft/geometry/mesh.hpp"

namespace cleft::geometry {
namespace {

using std::numbers::pi;

constexpr double kRadius = 0.4;
const Disc kDisc{{0.3, -0.2}, kRadius};

std::array<Vec2, 3> at_centre(const Vec2& a, const Vec2& b, const Vec2& c) {
  return {kDisc.centre + a, kDisc.centre + b, kDisc.centre + c};
}

TEST(Disc, HoldsATriangleInsideWhole) {
  EXPECT_NEAR(area_within(kDisc, at_centre({0.1, 0.0}, {0.2, 0.1}, {0.0, 0.2})), 0.015, 1e-16);
}

TEST(Disc, IsHeldWholeByALargeTriangle) {
  EXPECT_NEAR(area_within(kDisc, at_centre({-9.0, -5.0}, {9.0, -5.0}, {0.0, 9.0})), pi * kRadius * kRadius, 1e-14);
}

TEST(Disc, LeavesATriangleOutside) {
  EXPECT_EQ(area_within(kDisc, at_centre({1.0, 0.0}, {2.0, 0.0}, {1.0, 1.0})), 0.0);
  EXPECT_EQ(area_within(kDisc, at_centre({kRadius, 0.0}, {2.0, -1.0}, {2.0, 1.0})), 0.0);
  for (int k = 0; k < 100; ++k) {  // seen under any angle
    const double a = 0.0628 * k;
    const Vec2 t(std::cos(a), std::sin(a)), n = turn_left(t);
    EXPECT_EQ(area_within({kDisc.centre, 1e-9}, at_centre(0.1 * t, 0.5 * t - 0.3 * n, 0.4 * t + 0.2 * n)), 0.0) << k;
  }
}

TEST(Disc, SharesASectorAndASegment) {
  EXPECT_NEAR(area_within(kDisc, at_centre({0.0, 0.0}, {3.0, 0.0}, {0.0, 3.0})), 0.25 * pi * kRadius * kRadius, 1e-15);
  // beyond the chord at 0.2, half the radius
  const double segment = kRadius * kRadius * (pi / 3.0 - 0.5 * std::sin(2.0 * pi / 3.0));
  EXPECT_NEAR(area_within(kDisc, at_centre({0.2, -5.0}, {9.0, 0.0}, {0.2, 5.0})), segment, 1e-14);
}

// The parts of all triangles of a mesh make up the disc, wherever its centre lies, on nodes and edges too.
TEST(Disc, IsTheSumOfItsParts) {
  const Mesh mesh = structured_mesh({-1.0, -1.0, 1.0, 1.0}, {7, 9}, Diagonal::Alternating);
  std::vector<Vec2> centres{{0.013, -0.11}, {0.3, 0.2}, mesh.nodes[mesh.triangles[60][0]]};
  centres.push_back(0.5 * (mesh.nodes[mesh.triangles[60][0]] + mesh.nodes[mesh.triangles[60][1]]));
  for (const Vec2& centre : centres)
    for (const double radius : {1e-3, 0.11, 0.4}) {
      double area = 0.0;
      for (const auto& t : mesh.triangles)
        area += area_within({centre, radius}, {mesh.nodes[t[0]], mesh.nodes[t[1]], mesh.nodes[t[2]]});
      EXPECT_NEAR(area, pi * radius * radius, 1e-14) << centre.transpose() << ", " << radius;
    }
}

}  // namespace
}  // namespace cleft::geometry
