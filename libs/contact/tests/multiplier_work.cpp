// The work of mortar contact in one increment, on blocks that were pressed together by 1 Pa with friction 0.5.
#include <gtest/gtest.h>

#include "slider.hpp"

namespace cleft::contact {
namespace {

constexpr double kPressing = 1.0, kRough = 0.5;

class MultiplierWork : public testing::TestWithParam<NegativeSide> {
 protected:
  Slider s{GetParam()};
  MultiplierState before;

  MultiplierWork() {
    s.surfaces.laws[0] = Coulomb{kRough};
    s.add_multiplier_space(0.25);
    before = multipliers_at_rest(s.surfaces);
  }
  // How the traction that resists a slide of the upper block to the right is counted on the face of a node.
  double sense(std::size_t i) const {
    return s.surfaces.multiplier_space.nodes[i].side == geometry::Side::Right ? 1.0 : -1.0;
  }
  VecX tractions(double normal, double tangential) const {
    VecX out(2 * static_cast<Index>(before.status.size()));
    for (std::size_t i = 0; i < before.status.size(); ++i)
      out.segment<2>(2 * static_cast<Index>(i)) = Vec2(normal, sense(i) * tangential);
    return out;
  }
  // After an increment that took the upper block by `by`.
  CommittedMultipliers advanced(const Vec2& by, const VecX& tractions) {
    VecX x = s.shift(by);
    x.segment(2 * s.surfaces.first_multiplier, tractions.size()) = tractions / s.surfaces.mortar[0].scale;
    s.look(x);
    Multipliers now;
    now.run(s.surfaces, s.search.positions(), s.pairs, x, before);
    return now.commit(s.surfaces, s.search.positions(), before);
  }
};
INSTANTIATE_TEST_SUITE_P(Sides, MultiplierWork,
                         testing::Values(NegativeSide::Left, NegativeSide::Right, NegativeSide::Both));

TEST_P(MultiplierWork, OfSlidingIsTheMeanStrengthTimesTheSlip) {
  before.status.assign(before.status.size(), Status::Slip);
  before.multiplier = tractions(-kPressing, kRough * kPressing);
  const auto steady = advanced({0.03, 0.0}, before.multiplier);
  EXPECT_NEAR(steady.friction, kRough * kPressing * 0.03 * 0.97, 1e-12) << "of what is still opposite";
  EXPECT_NEAR(steady.pressure, 0.0, 1e-12) << "the faces are parallel";
  EXPECT_NEAR(steady.end.stored, 0.0, 1e-12) << "tractions are uniform";
  const auto harder = advanced({0.03, 0.0}, tractions(-3.0 * kPressing, 3.0 * kRough * kPressing));
  EXPECT_NEAR(harder.friction, 2.0 * kRough * kPressing * 0.03 * 0.97, 1e-12);
}

TEST_P(MultiplierWork, OnlyASlideAddsToTheStateOfTheLaw) {
  before.status.assign(before.status.size(), Status::Slip);
  before.multiplier = tractions(-kPressing, kRough * kPressing);
  for (auto& state : before.state) state.slip = 0.2;
  const auto stuck = advanced({0.0, 0.0}, tractions(-kPressing, 0.1)), slid = advanced({0.03, 0.0}, before.multiplier);
  double length = 0.0, sum = 0.0;
  for (std::size_t i = 0; i < before.state.size(); ++i) {
    EXPECT_EQ(before.state[i].slip, 0.2);
    EXPECT_EQ(stuck.end.state[i].slip, 0.2);
    length += s.surfaces.multiplier_space.nodes[i].length;
    sum += s.surfaces.multiplier_space.nodes[i].length * (slid.end.state[i].slip - 0.2);
  }
  EXPECT_NEAR(sum, 0.03 * 0.97 * length, 1e-12) << "of what is still opposite";
}

TEST_P(MultiplierWork, OfThePressureIsLostWhereTheEndOfTheOtherFaceLetsGo) {
  constexpr double kApart = 1e-4;  // how far the faces that bear it are apart
  before.status.assign(before.status.size(), Status::Slip);
  before.multiplier = tractions(-kPressing, kRough * kPressing);
  EXPECT_NEAR(advanced({0.03, kApart}, before.multiplier).pressure, -0.03 * kPressing * kApart, 1e-13);
  EXPECT_NEAR(advanced({0.03, -kApart}, before.multiplier).pressure, 0.03 * kPressing * kApart, 1e-13);
}

TEST_P(MultiplierWork, OfFacesThatStickIsNothing) {
  before.multiplier = tractions(-kPressing, 0.0);
  const auto stick = advanced({0.0, 0.0}, tractions(-kPressing, 0.3 * kRough));
  EXPECT_EQ(stick.friction, 0.0);
  EXPECT_NEAR(stick.pressure, 0.0, 1e-12);
}

TEST_P(MultiplierWork, OfFacesThatPartWithoutFrictionIsNothing) {
  s.surfaces.laws[0] = Coulomb{0.0};
  before.status.assign(before.status.size(), Status::Slip);
  before.multiplier = tractions(-kPressing, 0.0);
  const auto apart = advanced({0.02, 0.01}, tractions(0.0, 0.0));
  EXPECT_EQ(apart.friction, 0.0);
  EXPECT_EQ(apart.pressure, 0.0);
  EXPECT_EQ(apart.end.stored, 0.0);
}

TEST_P(MultiplierWork, OfFacesThatPartIsThatOfTheSlideWhichRelievesThem) {
  const double most = 0.5 * kRough * kPressing * 0.02 * 0.98;  // the strength falls to 0
  const Vec2 just_open(0.02, 1e-9);
  before.multiplier = tractions(-kPressing, kRough * kPressing);
  EXPECT_NEAR(advanced(just_open, tractions(0.0, 0.0)).friction, most, 1e-5 * most);
  before.multiplier = tractions(-kPressing, 0.6 * kRough * kPressing);
  const double sticks_first = advanced(just_open, tractions(0.0, 0.0)).friction;
  EXPECT_GE(sticks_first, 0.6 * most);
  EXPECT_LT(sticks_first, 0.9 * most);
}

TEST_P(MultiplierWork, OfFacesThatTouchIsThatOfHalfOfTheirSlide) {
  before.status.assign(before.status.size(), Status::Open);
  const auto touching = advanced({0.04, 0.0}, tractions(-kPressing, 0.0));
  EXPECT_NEAR(touching.friction, 0.5 * kRough * kPressing * 0.02 * 0.96, 1e-12);
}

}  // namespace
}  // namespace cleft::contact
