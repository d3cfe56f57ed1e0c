#include "cleft/geometry/common_area.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace cleft::geometry {
namespace {

using Triangle = std::array<Vec2, 3>;

const Triangle kHalfSquare{Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)};

double area(const Triangle& t) { return 0.5 * cross(t[1] - t[0], t[2] - t[0]); }

TEST(CommonArea, OfATriangleWithItselfIsItsArea) { EXPECT_EQ(common_area(kHalfSquare, kHalfSquare), 0.5); }

TEST(CommonArea, OfTrianglesThatOnlyTouchIsNone) {
  EXPECT_EQ(common_area(kHalfSquare, {Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)}), 0.0);        // along an edge
  EXPECT_EQ(common_area(kHalfSquare, {Vec2(1, 0), Vec2(2, 0), Vec2(2, 1)}), 0.0);        // at a corner
  EXPECT_EQ(common_area(kHalfSquare, {Vec2(3, 3), Vec2(4, 3), Vec2(3, 4)}), 0.0);        // not even that
  EXPECT_EQ(common_area(kHalfSquare, {Vec2(.2, .2), Vec2(.2, .2), Vec2(.2, .2)}), 0.0);  // a point
}

TEST(CommonArea, OfATriangleInsideIsItsOwn) {
  const Triangle inside{Vec2(0.25, 0.25), Vec2(0.5, 0.25), Vec2(0.25, 0.5)};
  EXPECT_EQ(common_area(kHalfSquare, inside), 0.03125);
  EXPECT_EQ(common_area(inside, kHalfSquare), 0.03125);
}

// Two equilateral triangles of side 1, one upside down, overlap in a hexagon of side 1/3.
TEST(CommonArea, OfAStarIsAHexagon) {
  Triangle up, down;
  for (int k = 0; k < 3; ++k) {
    const double angle = 2.0943951023931953 * k + 0.3, radius = 1.0 / std::sqrt(3.0);
    up[k] = Vec2(2.0, -7.0) + radius * Vec2(std::cos(angle), std::sin(angle));
    down[k] = Vec2(2.0, -7.0) - radius * Vec2(std::cos(angle), std::sin(angle));
  }
  EXPECT_NEAR(common_area(up, down), 1.5 * std::sqrt(3.0) / 9.0, 1e-15);
}

// Whatever a triangle is divided into, its parts have all of it in common with any other triangle: needles, too.
TEST(CommonArea, OfThePartsIsThatOfTheWhole) {
  std::mt19937 dice(7);
  std::uniform_real_distribution<double> place(-1.0, 1.0);
  const auto point = [&] { return Vec2(place(dice), place(dice)); };
  const auto triangle = [&] {
    Triangle t{point(), point(), point()};
    if (area(t) < 0.0) std::swap(t[1], t[2]);
    return t;
  };
  int common = 0;
  for (int k = 0; k < 1000; ++k) {
    const Triangle t = triangle(), other = triangle();
    const double along = k % 2 == 0 ? 0.5 * (1.0 + place(dice)) : 1e-9;
    const Vec2 middle = t[0] + along * (t[1] - t[0]);
    const double whole = common_area(t, other);
    EXPECT_NEAR(common_area({t[0], middle, t[2]}, other) + common_area({middle, t[1], t[2]}, other), whole, 1e-15);
    EXPECT_NEAR(common_area(other, t), whole, 1e-15);
    common += whole > 0.0;
  }
  EXPECT_GT(common, 500);
}

}  // namespace
}  // namespace cleft::geometry
