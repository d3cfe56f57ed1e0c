#include "predicates.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace cleft::geometry {
namespace {

TEST(Predicates, OrientationIsExact) {
  // 2^-53 off the line, which a determinant in doubles cannot see
  EXPECT_EQ(orientation({0, 0}, {3, 3}, {1, 1}), 0);
  EXPECT_EQ(orientation({0.5, 0.5}, {12, 12}, {24, std::nextafter(24.0, 25.0)}), 1);
  EXPECT_EQ(orientation({0.5, 0.5}, {12, 12}, {24, std::nextafter(24.0, 23.0)}), -1);
}

TEST(Predicates, ShiftedSidesAreNeverZeroAndAgree) {
  const Vec2 low(0, 0), right(1, 0), up(0, 1), far(2, 2), middle(1, 1);
  EXPECT_EQ(side_of_shifted_line(low, {2, 0}, right), -1);  // the line goes up
  EXPECT_EQ(side_of_shifted_line({2, 0}, low, right), 1);
  EXPECT_EQ(side_of_shifted_line(low, {0, 2}, up), 1);   // and to the right
  EXPECT_EQ(side_of_shifted_line(low, far, middle), 1);  // to the right more than up
  EXPECT_EQ(side_of_shifted_line(far, low, middle), -1);
  EXPECT_EQ(shifted_side_of_edge(low, {2, 0}, right), 1);
  EXPECT_EQ(shifted_side_of_edge({2, 0}, low, right), -1);
  EXPECT_EQ(shifted_side_of_edge(low, {0, 2}, up), -1);
  EXPECT_EQ(shifted_side_of_edge(low, far, middle), -1);
}

TEST(Predicates, TouchingSegmentsMeet) {
  EXPECT_TRUE(segments_meet({0, 0}, {2, 2}, {0, 2}, {2, 0}));
  EXPECT_TRUE(segments_meet({0, 0}, {2, 2}, {1, 1}, {5, 0}));
  EXPECT_TRUE(segments_meet({0, 0}, {2, 2}, {2, 2}, {5, 0}));
  EXPECT_TRUE(segments_meet({0, 0}, {2, 0}, {1, 0}, {3, 0}));
  EXPECT_FALSE(segments_meet({0, 0}, {2, 0}, {3, 0}, {4, 0}));
  EXPECT_FALSE(segments_meet({0, 0}, {2, 2}, {1, std::nextafter(1.0, 2.0)}, {1, 3}));
}

TEST(Predicates, FoldsBackOnlyAlongItself) {
  EXPECT_TRUE(folds_back({0, 0}, {2, 2}, {1, 1}));
  EXPECT_TRUE(folds_back({0, 0}, {0, 2}, {0, -4}));
  EXPECT_FALSE(folds_back({0, 0}, {2, 2}, {3, 3}));
  EXPECT_FALSE(folds_back({0, 0}, {2, 2}, {1, std::nextafter(1.0, 2.0)}));
}

TEST(Predicates, CrossingsAreOrderedAlsoWhereTheyCoincide) {
  const Vec2 a(0, 0), b(4, 0);
  EXPECT_EQ(compare_crossings(a, b, {{1, -1}, {1, 1}}, {{2, 1}, {2, -1}}), -1);
  EXPECT_EQ(compare_crossings(a, b, {{2, 1}, {2, -1}}, {{1, -1}, {1, 1}}), 1);
  // Two lines through (2, 0): shifted up, the one that leans to the right crosses further left.
  EXPECT_EQ(compare_crossings(a, b, {{1, -1}, {2, 0}}, {{2, 0}, {1, 1}}), -1);
  EXPECT_EQ(compare_crossings(a, b, {{1, -1}, {2, 0}}, {{2, 0}, {3, 1}}), 0);
  EXPECT_EQ(crossing_place(a, b, {{1, -1}, {1, 1}}), 0.25);
}

}  // namespace
}  // namespace cleft::geometry
