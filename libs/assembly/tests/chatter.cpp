#include "chatter.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace cleft::assembly {
namespace {

TEST(Chatter, IsTheReturnToAStateAtAResidualThatStays) {
  for (const int round : {2, 3, 7}) {
    Chatter chatter;
    for (int k = 0; k < round; ++k) EXPECT_FALSE(chatter.repeats({1, k}, 1.0 + 0.1 * k));
    EXPECT_TRUE(chatter.repeats({1, 0}, 0.9)) << round;
    EXPECT_FALSE(chatter.repeats({1, 1}, 0.9)) << "it watches anew";
  }
}

TEST(Chatter, IsNotAStateThatStaysOrAResidualThatFalls) {
  Chatter stays, falls, wanders;
  for (int k = 0; k < 10; ++k) {
    EXPECT_FALSE(stays.repeats({1, 2}, 1.0));
    EXPECT_FALSE(falls.repeats({k % 2}, std::pow(0.4, k)));
    EXPECT_FALSE(wanders.repeats({k}, 1.0));
  }
}

}  // namespace
}  // namespace cleft::assembly
