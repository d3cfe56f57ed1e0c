#include "difference.hpp"

#include <gtest/gtest.h>

namespace cleft::tangent_check {
namespace {

template <class Function>
Quotient of(const Function& f, double x, double step) {
  return quotient({f(x - 2 * step), f(x - step), f(x + step), f(x + 2 * step)}, step);
}

TEST(Quotient, IsExactForQuarticsAndKnowsTheTruncationOfTheCentralDifferences) {
  const auto cubic = [](double x) { return x * x * x; };
  const Quotient q = of(cubic, 0.5, 0.125);
  EXPECT_DOUBLE_EQ(q.value, 0.75);
  EXPECT_DOUBLE_EQ(q.uncertainty, 3 * 0.125 * 0.125);  // of h^2 and 4 h^2
  EXPECT_DOUBLE_EQ(of([&](double x) { return x * cubic(x); }, 0.5, 0.125).value, 0.5);
}

TEST(Quotient, IsUncertainAtAKink) {
  const auto bent = [](double x) { return x < 0.01 ? 0.0 : x - 0.01; };
  const Quotient q = of(bent, 0.0, 0.01);
  EXPECT_FALSE(is_certain(q, 1.0, 0.1));
  EXPECT_TRUE(is_certain(of(bent, 0.0, 0.001), 1.0, 1e-6));
}

TEST(FirstStep, IsAPowerOfTwoBetweenTruncationAndRounding) {
  for (const double influence : {1e-3, 0.07, 2.0})
    for (const double reach : {1e-3, 1.0, 300.0}) {
      const double h = first_step(influence, reach);
      EXPECT_EQ(std::exp2(std::round(std::log2(h))), h);
      EXPECT_LT(h, 1e-3 * influence);
      EXPECT_GT(h, 1e4 * 2.2e-16 * reach);
    }
}

TEST(LeastStep, LeavesDifferencesThatRoundingDoesNotHide) {
  EXPECT_LE(2.2e-16 * 3.0 / least_step(3.0, 1e-6), 0.25e-6);
  EXPECT_GE(2.2e-16 * 3.0 / least_step(3.0, 1e-6), 0.02e-6);
}

}  // namespace
}  // namespace cleft::tangent_check
