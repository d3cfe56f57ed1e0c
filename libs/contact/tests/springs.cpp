#include "cleft/contact/springs.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace cleft::contact {
namespace {

const InterfaceLaw kLaw = Coulomb{0.4};
const InterfaceLaw kLimited = LimitedCoulomb{.friction = 0.4, .limit = 5.0e6};
const Springs kSprings{2.0e12, 1.0e12};
const Touch kTouch{1e-15};
const InterfaceState kBegin{.slip = 0.25};

ContactResponse respond_to(const Gaps& gaps, const InterfaceLaw& law = kLaw) {
  return respond(law, kSprings, gaps, kTouch, kBegin);
}

TEST(PenaltyLaw, OpenFacesCarryNothing) {
  const Traction t = respond_to({1e-6, 3e-6, true}).traction;
  EXPECT_EQ(t.status, Status::Open);
  EXPECT_EQ(t.normal, 0.0);
  EXPECT_EQ(t.tangential, 0.0);
}

TEST(PenaltyLaw, StickIsElasticBelowTheCone) {
  const Traction t = respond_to({-1e-5, 5e-6, true}).traction;
  EXPECT_EQ(t.status, Status::Stick);
  EXPECT_DOUBLE_EQ(t.normal, -2.0e7);
  EXPECT_DOUBLE_EQ(t.tangential, 5.0e6);
}

TEST(PenaltyLaw, SlipReturnsTractionToConeInTheSenseOfTheGap) {
  for (const double sign : {1.0, -1.0}) {
    const Traction t = respond_to({-1e-5, sign * 1e-3, true}).traction;
    EXPECT_EQ(t.status, Status::Slip);
    EXPECT_DOUBLE_EQ(t.tangential, sign * 0.4 * 2.0e7);
  }
}

TEST(PenaltyLaw, AFirstTouchHasPressureOnly) {
  const Traction t = respond_to({-1e-5, 0.0, false}).traction;
  EXPECT_EQ(t.status, Status::Stick) << "it takes hold where it is";
  EXPECT_DOUBLE_EQ(t.normal, -2.0e7);
  EXPECT_EQ(t.tangential, 0.0);
}

TEST(PenaltyLaw, FacesAtRestAreClosedAndStick) {
  EXPECT_EQ(respond_to({0.0, 0.0, true}).traction.status, Status::Stick);
  EXPECT_EQ(respond_to({0.0, 0.0, false}).traction.status, Status::Open);
}

TEST(PenaltyLaw, WithoutFrictionEverythingSlides) {
  const Traction t = respond_to({-1e-5, 1e-7, true}, Coulomb{0.0}).traction;
  EXPECT_EQ(t.status, Status::Slip);
  EXPECT_EQ(t.tangential, 0.0);
}

TEST(PenaltyLaw, SlipReturnsTractionToTheStrengthOfTheLaw) {
  for (const double sign : {1.0, -1.0}) {
    const Traction t = respond_to({-1e-5, sign * 1e-3, true}, kLimited).traction;
    EXPECT_EQ(t.status, Status::Slip);
    EXPECT_DOUBLE_EQ(t.tangential, sign * 5.0e6 * (1.0 - std::exp(-0.4 * 2.0e7 / 5.0e6)));
  }
}

struct Branch {
  const char* name;
  Gaps gaps;
  Status status;
};

TEST(PenaltyLaw, StiffnessIsTheDerivativeOfTheTractionInEveryBranch) {
  constexpr double kStep = 1e-10;
  for (const auto& law : {kLaw, kLimited})
    for (const Branch& b :
         {Branch{"open", {1e-6, 3e-6, true}, Status::Open}, Branch{"first touch", {-1e-5, 0.0, false}, Status::Stick},
          Branch{"stick", {-1e-5, 2e-6, true}, Status::Stick}, Branch{"slip", {-1e-5, 1e-3, true}, Status::Slip},
          Branch{"slip back", {-1e-5, -1e-3, true}, Status::Slip}}) {
      const auto at = [&](double normal, double tangential) {
        return respond_to({b.gaps.normal + normal, b.gaps.tangential + tangential, b.gaps.anchored}, law).traction;
      };
      const auto [traction, stiffness, end] = respond_to(b.gaps, law);
      ASSERT_EQ(traction.status, b.status) << b.name;
      const auto rate = [&](double Traction::*of, const Gaps& along) {
        return (at(along.normal, along.tangential).*of - at(-along.normal, -along.tangential).*of) / (2.0 * kStep);
      };
      const double tolerance = 1e-8 * kSprings.normal;
      const Gaps normal{.normal = kStep}, tangential{.tangential = kStep};
      EXPECT_NEAR(rate(&Traction::normal, normal), stiffness.normal, tolerance) << b.name;
      EXPECT_EQ(rate(&Traction::normal, tangential), 0.0) << b.name;
      EXPECT_NEAR(rate(&Traction::tangential, normal), stiffness.by_normal * stiffness.normal, tolerance) << b.name;
      if (b.gaps.anchored) {
        EXPECT_NEAR(rate(&Traction::tangential, tangential), stiffness.tangential, tolerance) << b.name;
      }
    }
}

TEST(PenaltyLaw, OnlyASlideAddsToTheStateOfTheLaw) {
  for (const Gaps& gaps : {Gaps{1e-6, 3e-6, true}, Gaps{-1e-5, 0.0, false}, Gaps{-1e-5, 5e-6, true}})
    EXPECT_EQ(respond_to(gaps).end.slip, kBegin.slip);
  for (const double sign : {1.0, -1.0})
    EXPECT_DOUBLE_EQ(respond_to({-1e-5, sign * 1e-3, true}).end.slip, kBegin.slip + 1e-3 - 0.4 * 2.0e7 / 1.0e12);
}

TEST(Springs, StoreTheWorkOfTheTractionsUpToTheGaps) {
  const Traction t = respond_to({-1e-5, 5e-6, true}).traction;
  EXPECT_DOUBLE_EQ(kSprings.stored_energy(t.normal, t.tangential), 0.5 * (2.0e7 * 1e-5 + 5.0e6 * 5e-6));
}

}  // namespace
}  // namespace cleft::contact
