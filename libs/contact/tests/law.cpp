#include "cleft/contact/law.hpp"

#include <gtest/gtest.h>

namespace cleft::contact {
namespace {

const Law kLaw{2.0e12, 1.0e12, 0.4};
const Touch kTouch{1e-15};

TEST(PenaltyLaw, OpenFacesCarryNothing) {
  const Traction t = traction(kLaw, 1e-6, 3e-6, true, kTouch);
  EXPECT_EQ(t.status, Status::Open);
  EXPECT_EQ(t.normal, 0.0);
  EXPECT_EQ(t.tangential, 0.0);
}

TEST(PenaltyLaw, StickIsElasticBelowTheCone) {
  const Traction t = traction(kLaw, -1e-5, 5e-6, true, kTouch);
  EXPECT_EQ(t.status, Status::Stick);
  EXPECT_DOUBLE_EQ(t.normal, -2.0e7);
  EXPECT_DOUBLE_EQ(t.tangential, 5.0e6);
}

TEST(PenaltyLaw, SlipReturnsTractionToConeInTheSenseOfTheGap) {
  for (const double sign : {1.0, -1.0}) {
    const Traction t = traction(kLaw, -1e-5, sign * 1e-3, true, kTouch);
    EXPECT_EQ(t.status, Status::Slip);
    EXPECT_DOUBLE_EQ(t.tangential, sign * 0.4 * 2.0e7);
  }
}

TEST(PenaltyLaw, AFirstTouchHasPressureOnly) {
  const Traction t = traction(kLaw, -1e-5, 0.0, false, kTouch);
  EXPECT_EQ(t.status, Status::Stick) << "it takes hold where it is";
  EXPECT_DOUBLE_EQ(t.normal, -2.0e7);
  EXPECT_EQ(t.tangential, 0.0);
}

TEST(PenaltyLaw, FacesAtRestAreClosedAndStick) {
  EXPECT_EQ(traction(kLaw, 0.0, 0.0, true, kTouch).status, Status::Stick);
  EXPECT_EQ(traction(kLaw, 0.0, 0.0, false, kTouch).status, Status::Open);
}

TEST(PenaltyLaw, WithoutFrictionEverythingSlides) {
  const Traction t = traction({1e12, 1e12, 0.0}, -1e-5, 1e-7, true, kTouch);
  EXPECT_EQ(t.status, Status::Slip);
  EXPECT_EQ(t.tangential, 0.0);
}

}  // namespace
}  // namespace cleft::contact
