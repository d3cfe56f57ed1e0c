#include "chatter.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace cleft::assembly {
namespace {

Iteration at(double residual, int changes) {
  Iteration it;
  it.residual = residual;
  it.status_changes = changes;
  return it;
}

TEST(Chatter, IsPointsThatChangeWhileTheResidualStays) {
  Chatter chatter;
  for (int k = 0; k < 4; ++k) EXPECT_FALSE(chatter.halves(k, at(k % 2 ? 0.8 : 1.0, 1))) << k;
  EXPECT_TRUE(chatter.halves(4, at(1.0, 1)));
  EXPECT_TRUE(chatter.halves(5, at(0.7, 1))) << "better than the one before, but not than the least";
  EXPECT_FALSE(chatter.halves(6, at(0.3, 1))) << "this leads out";
  EXPECT_EQ(chatter.halved(), 2);
}

TEST(Chatter, IsNotAResidualThatFallsOrPointsThatRest) {
  Chatter falls, rests;
  for (int k = 0; k < 10; ++k) {
    EXPECT_FALSE(falls.halves(k, at(std::pow(0.4, k), 1)));
    EXPECT_FALSE(rests.halves(k, at(1.0, 0)));
  }
  EXPECT_EQ(falls.halved() + rests.halved(), 0);
}

}  // namespace
}  // namespace cleft::assembly
