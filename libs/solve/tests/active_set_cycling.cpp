#include "active_set_cycling.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace cleft::solve {
namespace {

constexpr int kMost = 12;  // iterations

Iteration at(double residual, int changes) {
  Iteration it;
  it.residual = residual;
  it.status_changes = changes;
  return it;
}

bool halves(ActiveSetCycling& cycling, int iteration, const Iteration& it, bool again = true) {
  cycling.look_at(iteration, it, again);
  return cycling.halves();
}

TEST(ActiveSetCycling, IsAnActiveSetMetAgainWhileTheResidualStays) {
  ActiveSetCycling cycling(kMost);
  for (int k = 0; k < 4; ++k) EXPECT_FALSE(halves(cycling, k, at(k % 2 ? 0.8 : 1.0, 1))) << k;
  EXPECT_TRUE(halves(cycling, 4, at(1.0, 1)));
  EXPECT_TRUE(halves(cycling, 5, at(0.7, 1))) << "better than the one before, but not than half of the least";
  EXPECT_FALSE(halves(cycling, 6, at(0.3, 1))) << "this leads out";
  EXPECT_EQ(cycling.halved(), 2);
}

TEST(ActiveSetCycling, IsPointsThatChangeWithoutProgress) {
  ActiveSetCycling cycling(kMost);
  for (int k = 0; k < 5; ++k) EXPECT_FALSE(halves(cycling, k, at(1.0 + k, 1), false)) << k;
  EXPECT_TRUE(halves(cycling, 5, at(6.0, 1), false));
}

TEST(ActiveSetCycling, IsNotAResidualThatFallsOrPointsThatRest) {
  ActiveSetCycling falls(kMost), rests(kMost);
  for (int k = 0; k < 10; ++k) {
    EXPECT_FALSE(halves(falls, k, at(std::pow(0.4, k), 1)));
    EXPECT_FALSE(halves(rests, k, at(1.0, 0)));
  }
  EXPECT_EQ(falls.halved() + rests.halved(), 0);
}

TEST(ActiveSetCycling, LetsAZipGoOnUntilItIsThrough) {
  ActiveSetCycling zip(kMost);
  for (int k = 0; k <= 30; ++k) {
    EXPECT_FALSE(halves(zip, k, at(1.0 - 0.01 * k, 2), false)) << k;
    EXPECT_FALSE(zip.is_over()) << k;
  }
  for (int k = 31; k < 36; ++k) {
    halves(zip, k, at(0.5, 0), false);
    EXPECT_FALSE(zip.is_over()) << k << ": what has just settled may converge";
  }
  halves(zip, 36, at(0.5, 0), false);
  EXPECT_TRUE(zip.is_over());
}

TEST(ActiveSetCycling, EndsWithTheIterationsAllowedWhereNothingChanges) {
  ActiveSetCycling cycling(kMost), one(1);
  for (int k = 0; k < kMost; ++k) {
    halves(cycling, k, at(std::pow(0.9, k), 0), false);
    EXPECT_FALSE(cycling.is_over()) << k;
  }
  halves(cycling, kMost, at(std::pow(0.9, kMost), 0), false);
  EXPECT_TRUE(cycling.is_over());
  halves(one, 0, at(1.0, 0), false);
  halves(one, 1, at(0.5, 3), false);
  EXPECT_TRUE(one.is_over()) << "one allowed";
}

TEST(ActiveSetCycling, EndsAZipThatHasNoEnd) {
  ActiveSetCycling cycling(kMost);
  for (int k = 0; k < 8 * kMost; ++k) {
    halves(cycling, k, at(1.0 - 1e-3 * k, 2), false);
    EXPECT_FALSE(cycling.is_over()) << k;
  }
  halves(cycling, 8 * kMost, at(0.5, 2), false);
  EXPECT_TRUE(cycling.is_over());
}

}  // namespace
}  // namespace cleft::solve
