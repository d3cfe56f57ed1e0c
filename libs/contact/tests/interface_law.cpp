// What methods expect of every interface law.
#include "cleft/contact/interface_law.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace cleft::contact {
namespace {

const std::vector<InterfaceLaw> kLaws{Coulomb{0.0}, Coulomb{0.3}, LimitedCoulomb{.friction = 0.3, .limit = 2.0e6}};
constexpr double kPressure = 4.0e6;  // Pa
const InterfaceState kBegin{.slip = 0.01};

TEST(InterfaceLaw, SlopeIsTheDerivativeOfTheStrength) {
  constexpr double kStep = 1e-5 * kPressure;
  for (const auto& law : kLaws)
    for (const double p : {-kPressure, -0.1 * kPressure, 0.2 * kPressure, kPressure, 10.0 * kPressure}) {
      const double rate =
          (strength(law, p + kStep, kBegin).value - strength(law, p - kStep, kBegin).value) / (2.0 * kStep);
      EXPECT_NEAR(rate, strength(law, p, kBegin).by_pressure, 1e-9) << law.index() << " at " << p;
    }
}

TEST(InterfaceLaw, StrengthAndItsSlopeAreContinuousWherePressureTurnsToTension) {
  constexpr double kLittle = 1e-6 * kPressure;
  for (const auto& law : kLaws) {
    const Strength above = strength(law, kLittle, kBegin), below = strength(law, -kLittle, kBegin);
    EXPECT_NEAR(above.value, below.value, 2.0 * kLittle) << law.index();
    EXPECT_NEAR(above.by_pressure, below.by_pressure, 1e-5) << law.index();
  }
}

TEST(Coulomb, StrengthIsProportionalToThePressure) {
  EXPECT_DOUBLE_EQ(Coulomb{0.3}.strength(kPressure, kBegin).value, 0.3 * kPressure);
}

TEST(LimitedCoulomb, IsCoulombsAtASmallPressureAndTheLimitAtALargeOne) {
  const LimitedCoulomb law{.friction = 0.3, .limit = 2.0e6};
  EXPECT_NEAR(law.strength(10.0, kBegin).value, 3.0, 1e-5);
  EXPECT_DOUBLE_EQ(law.strength(1e9, kBegin).value, law.limit);
  EXPECT_EQ(law.strength(1e12, kBegin).by_pressure, 0.0);
}

}  // namespace
}  // namespace cleft::contact
