#include "bracket.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace cleft::growth {
namespace {

// Narrows until the end above is within the tolerance of the one below; the number of looks.
template <class Demand>
int looks_until_found(const Demand& demand, double tolerance, double* found) {
  Bracket b{0.0, demand(0.0), 1.0, demand(1.0)};
  int looks = 0;
  while (b.high - b.low > tolerance && looks < 100) {
    const double load = next_look(b, tolerance, looks > 6);
    EXPECT_GT(load, b.low);
    EXPECT_LT(load, b.high);
    ++looks;
    if (demand(load) >= 1.0)
      b.high = load, b.demand_high = demand(load);
    else
      b.low = load, b.demand_low = demand(load);
  }
  *found = b.high;
  return looks;
}

TEST(Bracket, NeedsTwoLooksOnAStraightLine) {
  double found = 0.0;
  EXPECT_EQ(looks_until_found([](double load) { return 1.7 * load; }, 1e-4, &found), 2);
  EXPECT_NEAR(found, 1.0 / 1.7, 1e-4);
}

TEST(Bracket, FindsTheCrossingOfBentAndBrokenDemands) {
  const double crossing = 0.37;
  for (const double power : {0.2, 0.5, 2.0, 6.0}) {
    double found = 0.0;
    EXPECT_LT(looks_until_found([&](double load) { return std::pow(load / crossing, power); }, 1e-5, &found), 26);
    EXPECT_GE(found, crossing);
    EXPECT_LE(found, crossing + 1e-5);
  }
  double found = 0.0;
  EXPECT_LT(looks_until_found([&](double load) { return load < crossing ? 0.1 * load : 5.0; }, 1e-5, &found), 26);
  EXPECT_NEAR(found, crossing, 1e-5);
}

}  // namespace
}  // namespace cleft::growth
