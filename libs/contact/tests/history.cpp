// What contact points remember, on blocks in steady contact: pressure 1 Pa, strength 0.5 Pa, eps_T 2000 Pa/m.
#include "cleft/contact/history.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "slider.hpp"

namespace cleft::contact {
namespace {

constexpr double kDeep = 1e-3, kStrength = 0.5, kTangential = 2e3;
constexpr double kElastic = kStrength / kTangential;  // tangential gap at which sliding sets in

class History : public testing::TestWithParam<NegativeSide> {
 protected:
  Slider s{GetParam()};
  double sense = GetParam() == NegativeSide::Right ? 1.0 : -1.0;  // of the traction that resists: g_T = x_A - y

  // The points that stay clear of the mouths while the upper body slides by up to a fifth.
  bool inner(std::size_t p) const {
    const auto& face = s.surfaces.faces[s.surfaces.points[p].face];
    return face.s_start > 0.25 && face.s_end < 0.75;
  }
  template <class Check>
  void each(Check&& check) {
    int count = 0;
    for (std::size_t p = 0; p < s.pairs.size(); ++p)
      if (inner(p)) check(p), ++count;
    EXPECT_GT(count, 15);
  }
  void go(double along, double turn = 0.0) { s.look(s.shift({along, -kDeep}, turn)); }
  double tangential(std::size_t p) const { return s.pairs[p].state.traction.tangential; }
};
INSTANTIATE_TEST_SUITE_P(Sides, History, testing::Values(NegativeSide::Left, NegativeSide::Right));

TEST_P(History, SticksElasticallyAndKeepsItsAnchor) {
  const auto rest = s.past;
  go(0.6 * kElastic);
  each([&](std::size_t p) {
    EXPECT_EQ(s.pairs[p].state.traction.status, Status::Stick);
    EXPECT_NEAR(tangential(p), sense * 0.6 * kStrength, 1e-11);
  });
  s.commit();
  each([&](std::size_t p) {
    EXPECT_EQ(s.past[p].anchor_face, rest[p].anchor_face);
    EXPECT_EQ(s.past[p].anchor_place, rest[p].anchor_place);
    EXPECT_EQ(s.past[p].state.slip, 0.0);
  });
}

TEST_P(History, OnlyWhatHasConvergedChangesTheStateOfTheLaw) {
  for (const double along : {0.1, 0.05}) {  // two iterates of one increment
    go(along);
    each([&](std::size_t p) {
      EXPECT_EQ(s.past[p].state.slip, 0.0);
      EXPECT_NEAR(response(s.surfaces, static_cast<Index>(p), s.pairs[p], s.past[p]).end.slip, along - kElastic, 1e-12);
    });
  }
  s.commit();
  each([&](std::size_t p) { EXPECT_NEAR(s.past[p].state.slip, 0.05 - kElastic, 1e-12); });
}

TEST_P(History, AnAnchorOnAnotherCrackHoldsNothing) {
  for (auto& past : s.past) past.anchor_face = static_cast<Index>(s.surfaces.faces.size());
  auto elsewhere = s.surfaces.faces.front();
  elsewhere.crack = 1;
  s.surfaces.faces.push_back(elsewhere);
  s.surfaces.laws.push_back(s.surfaces.laws.front());
  s.surfaces.springs.push_back(s.surfaces.springs.front());
  s.surfaces.sides.push_back(s.surfaces.sides.front());
  go(0.6 * kElastic);
  each([&](std::size_t p) {
    EXPECT_EQ(s.pairs[p].state.traction.status, Status::Stick);
    EXPECT_EQ(tangential(p), 0.0);
  });
  s.commit();
  each([&](std::size_t p) { EXPECT_EQ(s.past[p].anchor_face, s.pairs[p].partner_face) << "it takes hold anew"; });
}

TEST_P(History, AReversalUnloadsFromTheTractionReachedAndSlidesBackAfterTwiceTheElasticGap) {
  go(0.1);
  s.commit();
  for (const auto& [back, expected] : {std::pair{0.5, 0.5}, {1.0, 0.0}, {1.5, -0.5}, {1.999, -0.999}}) {
    go(0.1 - back * kElastic);
    each([&](std::size_t p) {
      EXPECT_EQ(s.pairs[p].state.traction.status, Status::Stick);
      EXPECT_NEAR(tangential(p), sense * expected * kStrength, 1e-10);
    });
  }
  go(0.1 - 2.001 * kElastic);
  each([&](std::size_t p) {
    EXPECT_EQ(s.pairs[p].state.traction.status, Status::Slip);
    EXPECT_NEAR(tangential(p), -sense * kStrength, 1e-10);
  });
}

TEST_P(History, StickingAgainAfterAReversalGoesOnFromTheTractionReached) {
  go(0.1);
  s.commit();
  go(0.1 - 1.5 * kElastic);
  s.commit();  // sticks at minus half the strength
  go(0.1 - 0.7 * kElastic);
  each([&](std::size_t p) {
    EXPECT_EQ(s.pairs[p].state.traction.status, Status::Stick);
    EXPECT_NEAR(tangential(p), sense * 0.3 * kStrength, 1e-10);
  });
  go(0.12);
  each([&](std::size_t p) { EXPECT_NEAR(tangential(p), sense * kStrength, 1e-10); });
}

TEST_P(History, ALongElasticGapPutsTheAnchorManySegmentsBack) {
  s.surfaces.springs[0].tangential = 4.0;  // sliding sets in at an eighth of the body's width
  go(0.15);
  s.commit();
  each([&](std::size_t p) {
    const auto& point = s.surfaces.points[p];
    const auto &own = s.surfaces.faces[point.face], &face = s.surfaces.faces[s.past[p].anchor_face];
    const double here = own.s_start + point.eta * (own.s_end - own.s_start);
    const double anchor = face.s_start + s.past[p].anchor_place * (face.s_end - face.s_start);
    EXPECT_NEAR(anchor, here - sense * (0.15 - 0.125), 1e-12);
    EXPECT_GE(s.past[p].anchor_place, 0.0);
    EXPECT_LE(s.past[p].anchor_place, 1.0);
    EXPECT_NEAR(s.past[p].state.slip, 0.025, 1e-12);
  });
}

TEST_P(History, SteadySlidingDissipatesStrengthTimesSlipHoweverItIsDivided) {
  for (const int increments : {1, 7}) {
    Slider fresh(GetParam());
    std::swap(s, fresh);
    go(0.05);
    s.commit();
    std::vector<double> work(s.pairs.size(), 0.0), before(s.pairs.size());
    for (std::size_t p = 0; p < s.pairs.size(); ++p) before[p] = s.past[p].state.slip;
    for (int k = 1; k <= increments; ++k) {
      go(0.05 + 0.1 * k / increments);
      for (std::size_t p = 0; p < s.pairs.size(); ++p)
        work[p] += commit(s.surfaces, s.search.positions(), static_cast<Index>(p), s.pairs[p], s.past[p]).friction;
      s.commit();
    }
    each([&](std::size_t p) {
      EXPECT_NEAR(work[p], kStrength * 0.1, 1e-12);
      EXPECT_NEAR(s.past[p].state.slip - before[p], 0.1, 1e-12);
    });
  }
}

TEST_P(History, DissipationTakesTheMeanOfTractionsWhileSlidingGoesOnAndTheLastOneAfterAReversal) {
  const auto step = [&](double along, double deep) {
    s.look(s.shift({along, -deep}));
    std::vector<double> work;
    for (std::size_t p = 0; p < s.pairs.size(); ++p)
      work.push_back(commit(s.surfaces, s.search.positions(), static_cast<Index>(p), s.pairs[p], s.past[p]).friction);
    s.commit();
    return work;
  };
  step(0.05, kDeep);
  const auto harder = step(0.08, 3 * kDeep);  // strength grows threefold, and with it the elastic part of the gap
  each([&](std::size_t p) { EXPECT_NEAR(harder[p], 2 * kStrength * (0.03 - 2 * kElastic), 1e-12); });
  const auto back = step(0.05, 3 * kDeep);
  each([&](std::size_t p) { EXPECT_NEAR(back[p], 3 * kStrength * (0.03 - 6 * kElastic), 1e-12); });
}

TEST_P(History, APointThatSticksFirstSlidesAtTheStrengthFromThereOn) {
  go(0.5 * kElastic);
  s.commit();
  const double slide = 0.03;  // while the pressure and with it the strength grow threefold
  s.look(s.shift({0.5 * kElastic + slide, -3 * kDeep}));
  const double below = 0.5 * kStrength, beyond = 0.5 * kStrength + kTangential * slide - 3 * kStrength;
  const double at_onset = kStrength * (1.0 + 2.0 * below / (below + 0.03 * beyond));  // the body is softer
  each([&](std::size_t p) {
    const auto next = commit(s.surfaces, s.search.positions(), static_cast<Index>(p), s.pairs[p], s.past[p]);
    EXPECT_NEAR(next.friction, 0.5 * (at_onset + 3 * kStrength) * beyond / kTangential, 1e-12);
  });
}

TEST_P(History, APointThatOpensSlidesUntilItOpens) {
  go(0.1);
  s.commit();
  s.look(s.shift({0.12, kDeep}));  // opens in the middle of the increment
  each([&](std::size_t p) {
    const auto next = commit(s.surfaces, s.search.positions(), static_cast<Index>(p), s.pairs[p], s.past[p]);
    EXPECT_NEAR(next.friction, 0.5 * kStrength * (0.01 + kElastic), 1e-12);
    EXPECT_NEAR(next.pressure, 0.0, 1e-12);
  });
  s.surfaces.laws[0] = Coulomb{0.0};
  each([&](std::size_t p) {
    auto smooth = s.past[p];
    smooth.tangential = 0.0;
    EXPECT_EQ(commit(s.surfaces, s.search.positions(), static_cast<Index>(p), s.pairs[p], smooth).friction, 0.0);
  });
}

TEST_P(History, APointThatTouchesHasSlidOverHalfOfTheIncrement) {
  s.look(s.shift({0.0, kDeep}));
  s.commit();
  const FacePositions apart = s.search.positions();
  go(0.04);
  each([&](std::size_t p) {
    EXPECT_EQ(tangential(p), 0.0);
    EXPECT_NEAR(
        touching_friction(s.surfaces, apart, s.search.positions(), static_cast<Index>(p), s.pairs[p], s.past[p]),
        0.5 * kStrength * 0.02, 1e-12);
  });
}

TEST_P(History, DissipationIsNeverNegativeToAndFro) {
  double place = 0.0, total = 0.0;
  for (int k = 0; k < 60; ++k) {
    place += 0.02 * std::sin(1.7 * k) * std::cos(0.3 * k);
    go(place);
    each([&](std::size_t p) {
      const auto next = commit(s.surfaces, s.search.positions(), static_cast<Index>(p), s.pairs[p], s.past[p]);
      EXPECT_GE(next.friction, 0.0);
      EXPECT_GE(next.end.state.slip, s.past[p].state.slip);
      total += next.friction;
    });
    s.commit();
  }
  EXPECT_GT(total, 0.0);
}

TEST_P(History, RigidTurnsBetweenAllIncrementsChangeNothing) {
  Slider turned(GetParam());
  double turn = 0.0;
  for (const double along : {0.03, 0.09, 0.0899, 0.0898, 0.12}) {  // slide, slide, stick back twice, slide
    go(along);
    turned.look(turned.shift({along, -kDeep}, turn += 0.9));
    each([&](std::size_t p) {
      EXPECT_EQ(turned.pairs[p].state.traction.status, s.pairs[p].state.traction.status);
      EXPECT_NEAR(turned.pairs[p].state.traction.normal, s.pairs[p].state.traction.normal, 1e-11);
      EXPECT_NEAR(turned.pairs[p].state.traction.tangential, tangential(p), 1e-10);
    });
    s.commit();
    turned.commit();
    each([&](std::size_t p) { EXPECT_NEAR(turned.past[p].state.slip, s.past[p].state.slip, 1e-12); });
  }
}

TEST_P(History, OpeningForgetsTheAnchorButNotTheSlip) {
  go(0.1);
  s.commit();
  const auto slid = s.past;
  s.look(s.shift({0.1, kDeep}));
  s.commit();
  each([&](std::size_t p) {
    EXPECT_EQ(s.past[p].anchor_face, kNone);
    EXPECT_EQ(s.past[p].tangential, 0.0);
    EXPECT_EQ(s.past[p].state.slip, slid[p].state.slip);
  });
  go(0.13);
  s.commit();
  go(0.13 + 0.5 * kElastic);
  each([&](std::size_t p) {
    EXPECT_NEAR(tangential(p), sense * 0.5 * kStrength, 1e-10) << "anchored where it touched";
  });
}

}  // namespace
}  // namespace cleft::contact
