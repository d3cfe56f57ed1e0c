#include "unit.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace cleft::report {
namespace {

TEST(Unit, TakesThePrefixThatLeavesAtMostThreeDigitsBeforeThePoint) {
  const auto shown = [](double value, const std::string& unit) {
    const Unit u = unit_for(std::fabs(value), unit);
    return std::pair{value * u.scale, u.name};
  };
  const auto near = [](const std::pair<double, std::string>& seen, double value, const std::string& name) {
    EXPECT_NEAR(seen.first, value, 1e-12 * std::fabs(value));
    EXPECT_EQ(seen.second, name);
  };
  near(shown(-27.1e6, "N/m"), -27.1, "MN/m");
  near(shown(999.0, "Pa"), 999.0, "Pa");
  near(shown(1000.0, "Pa"), 1.0, "kPa");
  near(shown(2.5e-3, "m"), 2.5, "mm");
  near(shown(4e-7, "m"), 400.0, "nm");
  near(shown(5e16, "Pa"), 5e4, "TPa");
  near(shown(3e-20, "m"), 3e-8, "pm");
  near(shown(12345.0, ""), 12345.0, "");
  near(shown(0.0, "m"), 0.0, "m");
}

TEST(Unit, LargestOfPassesOverWhatIsNotFinite) {
  EXPECT_EQ(largest_of({1.0, -3.0, std::nan(""), INFINITY}), 3.0);
  EXPECT_EQ(largest_of({}), 0.0);
}

}  // namespace
}  // namespace cleft::report
