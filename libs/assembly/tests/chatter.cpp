#include "chatter.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace cleft::assembly {
namespace {

TEST(Chatter, IsTwoStatesInTurnAtAResidualThatStays) {
  Chatter chatter;
  EXPECT_FALSE(chatter.repeats({1, 2}, 1.0));
  EXPECT_FALSE(chatter.repeats({1, 3}, 0.9));
  EXPECT_FALSE(chatter.repeats({1, 2}, 0.8));
  EXPECT_TRUE(chatter.repeats({1, 3}, 0.9));
  EXPECT_FALSE(chatter.repeats({1, 2}, 0.8)) << "it counts anew";
}

TEST(Chatter, IsNotAStateThatStaysOrAResidualThatFalls) {
  Chatter stays, falls, wanders;
  for (int k = 0; k < 10; ++k) {
    EXPECT_FALSE(stays.repeats({1, 2}, 1.0));
    EXPECT_FALSE(falls.repeats({k % 2}, std::pow(0.2, k)));
    EXPECT_FALSE(wanders.repeats({k % 3}, 1.0));
  }
}

}  // namespace
}  // namespace cleft::assembly
