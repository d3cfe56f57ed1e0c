// Search and state on two flat faces that slide past each other.
#include <gtest/gtest.h>

#include "slider.hpp"

namespace cleft::contact {
namespace {

using geometry::Side;

class Sliding : public testing::TestWithParam<NegativeSide> {};
INSTANTIATE_TEST_SUITE_P(Sides, Sliding, testing::Values(NegativeSide::Left, NegativeSide::Right, NegativeSide::Both));

TEST_P(Sliding, PartnersAreThePointsOppositeHoweverLargeTheSlip) {
  Slider s(GetParam());
  for (const double along : {0.0, 0.013, 0.4, -0.37}) {
    s.look(s.shift({along, -1e-3}));
    int found = 0;
    for (std::size_t p = 0; p < s.pairs.size(); ++p) {
      const auto& pair = s.pairs[p];
      const auto& point = s.surfaces.points[p];
      const auto& own = s.surfaces.faces[point.face];
      const double x = own.reference_start.x() + point.eta * (own.reference_end - own.reference_start).x();
      const double opposite = x + (own.side == Side::Left ? along : -along);
      if (opposite < 0.0 || opposite > 1.0) {
        EXPECT_TRUE(pair.partner_face == kNone || pair.state.ramp < 1.0);
        continue;
      }
      ++found;
      ASSERT_NE(pair.partner_face, kNone);
      const auto& other = s.surfaces.faces[pair.partner_face];
      EXPECT_NE(other.side, own.side);
      EXPECT_NEAR(other.s_start + pair.state.partner * (other.s_end - other.s_start), opposite, 1e-12);
      EXPECT_NEAR(pair.state.normal_gap, -1e-3, 1e-14);
    }
    EXPECT_GT(found, 40);
  }
}

TEST_P(Sliding, PressureResultantFallsContinuouslyAsTheOverlapShrinks) {
  Slider s(GetParam());
  double last = 1e300;
  for (double along = 0.3; along < 0.42; along += 0.0021) {
    s.look(s.shift({along, -1e-3}));
    double force = 0.0;
    for (std::size_t p = 0; p < s.pairs.size(); ++p)
      if (s.pairs[p].partner_face != kNone)
        force -= s.surfaces.points[p].weight * s.pairs[p].state.ramp * s.pairs[p].state.traction.normal;
    EXPECT_NEAR(force, 1e3 * 1e-3 * (1.0 - along), 1e-12) << "the quadrature is clipped exactly at the projected mouth";
    EXPECT_LT(force, last);
    last = force;
  }
}

TEST_P(Sliding, AnOpenGapHasNoTraction) {
  Slider s(GetParam());
  s.look(s.shift({0.1, 1e-3}));
  for (const auto& pair : s.pairs) EXPECT_EQ(pair.state.traction.status, Status::Open);
  s.commit();
  for (const auto& m : s.past) EXPECT_EQ(m.anchor_face, kNone) << "opening forgets the anchor";
}

TEST_P(Sliding, TheNextIncrementStartsFromTheTractionJustReached) {
  Slider s(GetParam());
  for (const double along : {0.05, 0.2, 0.1}) {  // forth and back
    const VecX u = s.shift({along, -1e-3});
    s.look(u);
    const auto before = s.pairs;
    const auto past = s.past;
    s.commit();
    s.look(u);
    for (std::size_t p = 0; p < s.pairs.size(); ++p) {
      // open, or back from beyond the mouth and so touching for the first time
      if (before[p].state.traction.status == Status::Open || past[p].anchor_face == kNone) continue;
      EXPECT_EQ(before[p].state.traction.status, Status::Slip);
      EXPECT_NEAR(std::fabs(before[p].state.traction.tangential), 0.5 * 1e3 * 1e-3, 1e-10);
      EXPECT_NEAR(s.pairs[p].state.traction.tangential, before[p].state.traction.tangential, 1e-10);
    }
  }
}

TEST_P(Sliding, ARigidTurnBetweenIncrementsChangesNothing) {
  Slider s(GetParam());
  s.look(s.shift({0.05, -1e-3}));
  s.commit();
  s.look(s.shift({0.0501, -1e-3}));
  const auto before = s.pairs;
  s.look(s.shift({0.0501, -1e-3}, 1.3));
  for (std::size_t p = 0; p < s.pairs.size(); ++p) {
    EXPECT_NEAR(s.pairs[p].state.traction.normal, before[p].state.traction.normal, 1e-11);
    EXPECT_NEAR(s.pairs[p].state.traction.tangential, before[p].state.traction.tangential, 1e-11);
  }
}

TEST_P(Sliding, FrictionDissipatesPressureTimesSlip) {
  Slider s(GetParam());
  s.look(s.shift({0.05, -1e-3}));
  s.commit();
  s.look(s.shift({0.08, -1e-3}));
  // Springs: 1 Pa on 1e3 Pa/m and 0.5 Pa on 2e3 Pa/m; a share that passes the mouth takes its part of them along.
  const double stored = 0.5 * (1.0 / 1e3 + 0.25 / 2e3);
  int passing = 0;
  for (std::size_t p = 0; p < s.pairs.size(); ++p) {
    if (s.pairs[p].state.traction.status != Status::Slip || s.past[p].anchor_face == kNone) continue;
    const auto a = commit(s.surfaces, s.search.positions(), static_cast<Index>(p), s.pairs[p], s.past[p]);
    const double before = s.past[p].ramp, after = s.pairs[p].state.ramp;
    passing += before != after;
    EXPECT_NEAR(a.friction, 0.5 * 0.03 * 0.5 * (before + after), 1e-12);
    EXPECT_NEAR(a.pressure, stored * (before - after), 1e-12);
    EXPECT_NEAR(a.end.state.slip - s.past[p].state.slip, 0.03, 1e-12);
  }
  EXPECT_GT(passing, 0) << "the test must see the mouth";
}

TEST_P(Sliding, SpringsThatRunPastTheMouthAreLost) {
  Slider s(GetParam());
  s.look(s.shift({0.05, -1e-3}));
  s.commit();
  s.look(s.shift({0.5, -1e-3}));
  int gone = 0;
  for (std::size_t p = 0; p < s.pairs.size(); ++p) {
    if (s.pairs[p].partner_face != kNone || s.past[p].ramp == 0.0) continue;
    ++gone;
    const auto a = commit(s.surfaces, s.search.positions(), static_cast<Index>(p), s.pairs[p], s.past[p]);
    EXPECT_NEAR(a.pressure, s.past[p].ramp * 0.5 * (1.0 / 1e3 + 0.25 / 2e3), 1e-12);
    EXPECT_EQ(a.end.ramp, 0.0);
    EXPECT_EQ(a.end.anchor_face, kNone);
  }
  EXPECT_GT(gone, 5);
}

TEST_P(Sliding, AFirstTouchIsAnchoredAtThePartner) {
  Slider s(GetParam());
  s.look(s.shift({0.1, 1e-3}));
  s.commit();
  s.look(s.shift({0.1, -1e-3}));
  for (const auto& pair : s.pairs) EXPECT_EQ(pair.state.traction.tangential, 0.0);
  const auto before = s.pairs;
  s.commit();
  for (std::size_t p = 0; p < s.pairs.size(); ++p)
    EXPECT_EQ(s.past[p].anchor_face, before[p].state.traction.status == Status::Open ? kNone : before[p].partner_face);
}

}  // namespace
}  // namespace cleft::contact
