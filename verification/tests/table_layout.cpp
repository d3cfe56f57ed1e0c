// The table itself: what it says and when a row holds.
#include <gtest/gtest.h>

#include <cmath>

#include "table.hpp"

namespace cleft::verification {
namespace {

TEST(Comparison, HoldsUpToItsToleranceAndNeverForWhatIsNotANumber) {
  Comparison row{"block", "force", exact(-200.0), -203.0, within(3.0, "penalty"), 0.1};
  EXPECT_TRUE(row.holds());
  row.tolerance.value = 2.9;
  EXPECT_FALSE(row.holds());
  row.tolerance = within_part(0.0151, "penalty");
  EXPECT_DOUBLE_EQ(row.error(), 0.015);
  EXPECT_TRUE(row.holds());
  row.tolerance.value = 0.0149;
  EXPECT_FALSE(row.holds());
  row.result = std::nan("");
  EXPECT_FALSE(row.holds());
  row.tolerance.value = HUGE_VAL;
  EXPECT_FALSE(row.holds());
}

TEST(Table, HasALineForEachComparisonAndEachReasonOnce) {
  const std::string text =
      table_of({{"block", "force", outside(-200.0), -203.0, within_part(0.02, "penalty"), 1.5},
                {"block", "slip", exact(0.0), 1e-3, within(1e-4, "rounding"), 1.5},
                {"drag", "force ratio", prototype(0.3), 0.3, within_part(0.02, "penalty"), 12.25}});
  EXPECT_EQ(text,
            "case   quantity     reference       kind  result  error  tolerance  why  seconds  holds\n"
            "block  force             -200    outside    -203  1.5 %        2 %  [1]     1.50    yes\n"
            "block  slip                 0      exact   0.001  0.001     0.0001  [2]     1.50     NO\n"
            "drag   force ratio        0.3  prototype     0.3    0 %        2 %  [1]    12.25    yes\n"
            "3 comparisons, 1 do not hold. Why the tolerances are what they are:\n"
            "  [1] penalty\n"
            "  [2] rounding\n");
}

}  // namespace
}  // namespace cleft::verification
