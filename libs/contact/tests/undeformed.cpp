// Contact at small strain, on the two blocks of slider.hpp.
#include "cleft/contact/undeformed.hpp"

#include <gtest/gtest.h>

#include "slider.hpp"

namespace cleft::contact {
namespace {

constexpr double kNormal = 1e3, kAlong = 2e3, kFriction = 0.5;

class Undeformed : public testing::TestWithParam<NegativeSide> {
 protected:
  Slider s = [] {
    Slider out(GetParam());
    out.surfaces.undeformed = true;
    return out;
  }();
  double sense = GetParam() == NegativeSide::Right ? 1.0 : -1.0;  // of g_T as the upper body slides to the right
};
INSTANTIATE_TEST_SUITE_P(Sides, Undeformed, testing::Values(NegativeSide::Left, NegativeSide::Right));

TEST_P(Undeformed, ThePartnerStaysThePointOppositeHoweverFarTheFacesSlide) {
  for (const double along : {0.0, 0.3, -2.0}) {
    s.look(s.shift({along, -1e-3}));
    for (std::size_t p = 0; p < s.pairs.size(); ++p) {
      EXPECT_EQ(s.pairs[p].partner_face, enrichment::opposite_face(s.surfaces.points[p].face));
      EXPECT_EQ(s.pairs[p].state.partner, s.surfaces.points[p].eta);
      EXPECT_NEAR(s.pairs[p].state.normal_gap, -1e-3, 1e-15);
    }
  }
}

TEST_P(Undeformed, TractionsFollowTheLawThroughSlidingAndReversal) {
  const double strength = kFriction * kNormal * 1e-3, elastic = strength / kAlong;
  const auto expect = [&](double along, Status status, double tangential, double slip) {
    s.look(s.shift({along, -1e-3}));
    for (const auto& pair : s.pairs) {
      EXPECT_EQ(pair.state.traction.status, status) << along;
      EXPECT_NEAR(pair.state.traction.tangential, sense * tangential, 1e-12) << along;
    }
    s.commit();
    for (const auto& past : s.past) EXPECT_NEAR(past.state.slip, slip, 1e-14) << along;
  };
  expect(0.5 * elastic, Status::Stick, 0.5 * strength, 0.0);
  expect(0.1, Status::Slip, strength, 0.1 - elastic);
  expect(0.1 - 0.5 * elastic, Status::Stick, 0.5 * strength, 0.1 - elastic);
  expect(0.3, Status::Slip, strength, 0.3 - elastic);
  expect(0.1, Status::Slip, -strength, 0.3 - elastic + 0.2 - 2.0 * elastic);
}

TEST_P(Undeformed, ForceIsLinearOnEveryBranchAndItsTangentItsSlope) {
  const double elastic = kFriction * kNormal * 1e-3 / kAlong;
  for (const double along : {0.5 * elastic, 3.0 * elastic, -3.0 * elastic}) {
    const VecX u = s.shift({along, -1e-3}, 1e-6);
    s.look(u);
    const Index p = 7;
    const Pair pair = s.pairs[p];
    const PairForce exact = force_undeformed(s.surfaces, p, pair, s.past[p]);
    FacePositions at = s.search.positions();
    const Index own = s.surfaces.points[p].face, other = pair.partner_face;
    const std::array<Vec2*, 4> points{&at.start[own], &at.end[own], &at.start[other], &at.end[other]};
    constexpr double kStep = 1e-5;
    for (int k = 0; k < 8; ++k) {
      double& x = (*points[k / 2])(k % 2);
      const double here = x;
      x = here + kStep;
      const auto up = force_undeformed(s.surfaces, p, opposite(s.surfaces, at, p, s.past[p]), s.past[p]).force;
      x = here - kStep;
      const auto down = force_undeformed(s.surfaces, p, opposite(s.surfaces, at, p, s.past[p]), s.past[p]).force;
      x = here;
      const auto slope = ((up - down) / (2.0 * kStep)).eval();
      EXPECT_LT((slope - exact.tangent.col(k)).cwiseAbs().maxCoeff(), 1e-8 * exact.tangent.cwiseAbs().maxCoeff());
    }
    EXPECT_EQ(exact.tangent.rightCols<4>().norm(), 0.0);
    EXPECT_LT((exact.force.head<4>() + exact.force.tail<4>()).norm(), 1e-12) << "the faces press each other alike";
  }
}

}  // namespace
}  // namespace cleft::contact
