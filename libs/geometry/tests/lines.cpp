#include "cleft/geometry/lines.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "cleft/support/error.hpp"

namespace cleft::geometry {
namespace {

std::vector<double> sizes(const std::vector<double>& lines) {
  std::vector<double> out;
  for (std::size_t k = 1; k < lines.size(); ++k) out.push_back(lines[k] - lines[k - 1]);
  return out;
}

TEST(GradedLines, AreEqualInTheFocusAndGrowByOneFactorOutside) {
  for (const int cells : {20, 40, 80}) {
    const auto lines = graded_lines(-10.0, 12.0, cells, {-1.5, 2.0, 0.6});
    ASSERT_EQ(lines.size(), static_cast<std::size_t>(cells) + 1);
    EXPECT_EQ(lines.front(), -10.0);
    EXPECT_EQ(lines.back(), 12.0);
    const auto from = std::find(lines.begin(), lines.end(), -1.5), to = std::find(lines.begin(), lines.end(), 2.0);
    ASSERT_NE(from, lines.end());
    ASSERT_EQ(to - from, 0.6 * cells) << "the ends of the focus are lines";
    const auto size = sizes(lines);
    const auto first = from - lines.begin(), last = to - lines.begin();
    for (auto k = first; k < last; ++k) EXPECT_NEAR(size[k], 3.5 / (0.6 * cells), 1e-13);
    const double left = size[first - 1] / size[first], right = size[last] / size[last - 1];
    EXPECT_NEAR(left / right, 1.0, 0.1) << "both sides grow alike";
    for (auto k = first - 1; k > 0; --k) EXPECT_NEAR(size[k - 1] / size[k], left, 1e-6);
    for (auto k = last; k + 1 < cells; ++k) EXPECT_NEAR(size[k + 1] / size[k], right, 1e-6);
    EXPECT_GT(left, 1.0);
  }
}

TEST(GradedLines, MayTouchAnEnd) {
  const auto lines = graded_lines(0.0, 4.0, 10, {0.0, 1.0, 0.5});
  EXPECT_EQ(lines[5], 1.0);
  EXPECT_NEAR(sizes(lines)[4], 0.2, 1e-14);
  EXPECT_GT(sizes(lines)[9], sizes(lines)[5]);
  EXPECT_EQ(graded_lines(0.0, 4.0, 8, {0.0, 4.0, 0.5}), even_lines(0.0, 4.0, 8));
}

TEST(GradedLines, RefuseToShrinkOutside) {
  EXPECT_THROW(graded_lines(0.0, 1.0, 10, {0.3, 0.7, 0.2}), InputError);
  EXPECT_THROW(graded_lines(0.0, 1.0, 10, {0.3, 0.7, 0.95}), InputError) << "no cells are left";
}

}  // namespace
}  // namespace cleft::geometry
