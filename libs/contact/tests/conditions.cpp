// The conditions of single nodes of mortar contact, in every branch: which holds when, what it says, and how it depends
// on the node's integrals, on its own tractions and on those of its neighbours.
#include <gtest/gtest.h>

#include "cleft/contact/multipliers.hpp"
#include "slider.hpp"

namespace cleft::contact {
namespace {

constexpr double kScale = 1e3, kFriction = 0.5;  // c in Pa/m, mu
constexpr Index kNode = 2;                       // in the middle of five

// Where the upper block is, and the tractions of all nodes, Pa.
struct Place {
  Vec2 by;
  VecX tractions;

  Place moved(const Place& direction, double step) const {
    return {by + step * direction.by, tractions + step * direction.tractions};
  }
};

// Five nodes on the lower face of a slider.
struct Joint : Slider {
  MultiplierState multiplier_state;

  explicit Joint(double smoothing = 2.0, NegativeSide side = NegativeSide::Right) : Slider(side) {
    surfaces.laws[0] = Coulomb{kFriction};
    surfaces.mortar = {{true, 1.0, smoothing, kScale, 1.0 / kScale}};
    std::vector<MultiplierSpacing> plan(surfaces.faces.size());
    const double factor = side == NegativeSide::Both ? 0.5 : 1.0;
    for (std::size_t f = 0; f < plan.size(); ++f)
      if (surfaces.is_negative(surfaces.faces[f])) plan[f] = {0.25, factor};
    surfaces.multiplier_space = make_multiplier_space(surfaces.faces, plan);
    surfaces.first_multiplier = unknowns.count;
    multiplier_state = multipliers_at_rest(surfaces);
  }

  Index nodes() const { return static_cast<Index>(surfaces.multiplier_space.nodes.size()); }

  // The upper block at `by`, the same tractions everywhere but for a little that differs from node to node.
  Place place(const Vec2& by, double normal, double tangential) const {
    Place out{by, VecX(2 * nodes())};
    for (Index i = 0; i < nodes(); ++i) {
      out.tractions[2 * i] = normal * (1.0 + 0.02 * static_cast<double>(i * i % 7));
      out.tractions[2 * i + 1] = tangential * (1.0 + 0.03 * static_cast<double>(i * i % 5));
    }
    return out;
  }

  Multipliers at(const Place& place) {
    VecX x(unknowns.components() + 2 * nodes());
    x << shift(place.by), place.tractions / kScale;
    look(x);
    Multipliers out;
    out.run(surfaces, search.positions(), pairs, x, multiplier_state);
    return out;
  }
};

// Compares a node's condition with differences along a direction in which everything changes.
void expect_derivative(Joint& joint, const Place& place, Index node) {
  Place direction{{0.31, 0.17}, VecX(place.tractions.size())};
  for (Index k = 0; k < direction.tractions.size(); ++k)
    direction.tractions[k] = std::cos(1.0 + 2.0 * static_cast<double>(k)) * 10.0;
  const double step = 1e-8;
  const Multipliers here = joint.at(place), ahead = joint.at(place.moved(direction, step)),
                    behind = joint.at(place.moved(direction, -step));
  const auto& space = joint.surfaces.multiplier_space;
  const auto rate = [&](const auto& of) { return ((of(ahead) - of(behind)) / (2.0 * step)); };
  const auto cover = [&](const Multipliers& m, Index interval) {
    double out = 0.0;
    for (std::size_t o = 0; o < m.mortar_pairs().size(); ++o)
      if (space.interval_parts[m.mortar_pairs()[o].interval_part].interval == interval)
        out += m.integrals()[o].value(kSupportOutput) + m.integrals()[o].value(kSupportOutput + 1);
    return out;
  };
  const auto& condition = here.conditions()[node];
  const Vec2 integrals(rate([&](const auto& m) { return m.nodes()[node].gap; }),
                       rate([&](const auto& m) { return m.nodes()[node].slip; }));
  // what the node's own traction does is in by_own
  const auto beyond_own = [&](const auto& m) -> Vec2 {
    return m.nodes()[node].beyond - here.nodes()[node].support * m.nodes()[node].traction();
  };
  const Vec2 beyond =
      here.facing().empty() ? Vec2::Zero() : Vec2((beyond_own(ahead) - beyond_own(behind)) / (2.0 * step));
  Vec2 expected = condition.by_integral.cwiseProduct(integrals) + condition.by_beyond.cwiseProduct(beyond) +
                  condition.by_own * direction.tractions.segment<2>(2 * node) / kScale;
  for (int k = 0; k < 2; ++k) {
    const Index e = k == 0 ? space.nodes[node].before : space.nodes[node].after;
    if (e == kNone) continue;
    const Index other = k == 0 ? space.intervals[e].first : space.intervals[e].second;
    expected += condition.by_neighbour[k] * direction.tractions.segment<2>(2 * other) / kScale +
                condition.by_cover[k] * rate([&](const auto& m) { return cover(m, e); });
  }
  const Vec2 seen(rate([&](const auto& m) { return m.conditions()[node].value.x(); }),
                  rate([&](const auto& m) { return m.conditions()[node].value.y(); }));
  for (const auto* near : {&ahead, &behind}) ASSERT_EQ(near->nodes()[node].status, here.nodes()[node].status);
  EXPECT_LT((seen - expected).norm(), 1e-6 * expected.norm()) << seen.transpose() << " : " << expected.transpose();
}

// Z_i of uniform intervals, without what the past and the cover add.
double smooth(const Joint& joint, const Place& place, int component) {
  const auto q = [&](Index i) { return place.tractions[2 * i + component]; };
  return joint.surfaces.mortar[0].smoothing / kScale * 0.25 / 12.0 * (2.0 * q(kNode) - q(kNode - 1) - q(kNode + 1));
}

TEST(NodeCondition, OpenNodeBearsNothing) {
  Joint joint;
  const Place place = joint.place({0.001, 1e-2}, -1.0, 0.1);
  const auto m = joint.at(place);
  EXPECT_EQ(m.nodes()[kNode].status, Status::Open);
  EXPECT_NEAR(m.nodes()[kNode].gap, 0.25 * 1e-2, 1e-12);
  EXPECT_NEAR((m.conditions()[kNode].value - 0.25 * place.tractions.segment<2>(2 * kNode)).norm(), 0.0, 1e-14);
  expect_derivative(joint, place, kNode);
}

TEST(NodeCondition, TensionOpensAndPressureHoldsWhereTheFacesTouch) {
  Joint joint;
  EXPECT_EQ(joint.at(joint.place({0.0, 0.0}, 1.0, 0.0)).nodes()[kNode].status, Status::Open);
  EXPECT_NE(joint.at(joint.place({0.0, 0.0}, -1.0, 0.0)).nodes()[kNode].status, Status::Open);
  // a gap up to L_i l_N / c is closed by the next iterate
  EXPECT_NE(joint.at(joint.place({0.0, 0.9e-3}, -1.0, 0.0)).nodes()[kNode].status, Status::Open);
  EXPECT_EQ(joint.at(joint.place({0.0, 1.2e-3}, -1.0, 0.0)).nodes()[kNode].status, Status::Open);
}

TEST(NodeCondition, ClosedNodeThatSticksLeavesNeitherGapNorSlipButForTheSmoothing) {
  for (const double smoothing : {0.0, 2.0}) {
    Joint joint(smoothing);
    const Place place = joint.place({1e-5, -2e-5}, -1.0, 0.1);
    const auto m = joint.at(place);
    const auto& node = m.nodes()[kNode];
    EXPECT_EQ(node.status, Status::Stick);
    EXPECT_NEAR(node.gap, -0.25 * 2e-5, 1e-14);
    EXPECT_NEAR(std::fabs(node.slip), 0.25 * 1e-5, 1e-14);
    EXPECT_NEAR(m.conditions()[kNode].value.x(), kScale * (node.gap - smooth(joint, place, 0)), 1e-13);
    EXPECT_NEAR(m.conditions()[kNode].value.y(), kScale * (node.slip - smooth(joint, place, 1)), 1e-13);
    expect_derivative(joint, place, kNode);
  }
}

TEST(NodeCondition, SlidingNodeBearsTheStrengthOfItsLaw) {
  const LimitedCoulomb law{.friction = kFriction, .limit = 0.3};
  for (const auto side : {NegativeSide::Right, NegativeSide::Both})
    for (const double along : {-2e-3, 2e-3}) {
      Joint joint(2.0, side);
      joint.surfaces.laws[0] = law;
      const double sense = joint.at(joint.place({along, -2e-5}, -1.0, 0.0)).nodes()[kNode].slip > 0.0 ? 1.0 : -1.0;
      const Place place = joint.place({along, -2e-5}, -1.0, 0.2 * sense);
      const auto m = joint.at(place);
      const auto& node = m.nodes()[kNode];
      ASSERT_EQ(node.status, Status::Slip);
      const double strength = 0.3 * (1.0 - std::exp(kFriction * node.normal / 0.3));
      const double length = joint.surfaces.multiplier_space.nodes[kNode].length;
      EXPECT_NEAR(m.conditions()[kNode].value.y(), length * (node.tangential - sense * strength), 1e-14);
      expect_derivative(joint, place, kNode);
    }
}

TEST(NodeCondition, SlidingNodeBearsFrictionAgainstTheSenseOfItsSlip) {
  for (const double along : {-2e-3, 2e-3}) {
    Joint joint;
    const double sense = joint.at(joint.place({along, -2e-5}, -1.0, 0.0)).nodes()[kNode].slip > 0.0 ? 1.0 : -1.0;
    const Place place = joint.place({along, -2e-5}, -1.0, 0.2 * sense);
    const auto m = joint.at(place);
    const auto& node = m.nodes()[kNode];
    EXPECT_EQ(node.status, Status::Slip);
    EXPECT_EQ(node.slides, sense);
    EXPECT_NEAR(m.conditions()[kNode].value.y(), 0.25 * (node.tangential + sense * kFriction * node.normal), 1e-14);
    expect_derivative(joint, place, kNode);
  }
}

TEST(NodeCondition, NodeThatSlidOneWaySticksBeforeItSlidesTheOther) {
  Joint joint;
  const double along = 2e-3;
  const double sense = joint.at(joint.place({along, 0.0}, -1.0, 0.0)).nodes()[kNode].slip > 0.0 ? 1.0 : -1.0;
  const Place strong = joint.place({along, 0.0}, -1.0, -0.3 * sense),
              weak = joint.place({along, 0.0}, -1.0, -0.2 * sense);
  EXPECT_EQ(joint.at(strong).nodes()[kNode].status, Status::Stick) << "above half of its strength, against its slip";
  EXPECT_EQ(joint.at(weak).nodes()[kNode].status, Status::Slip);
  expect_derivative(joint, strong, kNode);
  expect_derivative(joint, weak, kNode);
}

TEST(NodeCondition, FirstTouchBearsPressureAlone) {
  Joint joint;
  joint.multiplier_state.status[kNode] = Status::Open;
  const Place place = joint.place({2e-3, -2e-5}, -1.0, 0.2);
  const auto m = joint.at(place);
  EXPECT_EQ(m.nodes()[kNode].status, Status::Stick);
  EXPECT_NEAR(m.conditions()[kNode].value.y(), 0.25 * m.nodes()[kNode].tangential, 1e-14);
  expect_derivative(joint, place, kNode);
}

TEST(NodeCondition, WhatStuckBeforeSmoothsTheChangeOfItsTractionOnly) {
  Joint joint;
  const Place place = joint.place({0.0, 0.0}, -1.0, 0.1);
  joint.multiplier_state.multiplier = place.tractions;
  EXPECT_NEAR(joint.at(place).conditions()[kNode].value.y(), 0.0, 1e-14);
  EXPECT_GT(std::fabs(smooth(joint, place, 1)), 1e-7);
  expect_derivative(joint, place, kNode);
}

// Wherever the blocks are, and whatever tractions they have come to: the same place once more asks for the same ones.
TEST(NodeCondition, NothingThatSticksAsksForAChangeWhereNothingMoves) {
  for (const double smoothing : {0.0, 2.0})
    for (const auto side : {NegativeSide::Right, NegativeSide::Both})
      for (const double along : {0.0, 0.11, 0.23, 0.26}) {
        Joint joint(smoothing, side);
        const Place place = joint.place({along, 0.0}, -1.0, 0.1);
        joint.multiplier_state =
            joint.at(place).commit(joint.surfaces, joint.search.positions(), joint.multiplier_state).end;
        const auto m = joint.at(place);
        int seen = 0;
        for (Index i = 0; i < joint.nodes(); ++i) {
          if (!m.nodes()[i].supported || joint.multiplier_state.status[i] == Status::Open) continue;
          EXPECT_EQ(m.nodes()[i].status, Status::Stick);
          EXPECT_NEAR(m.conditions()[i].value.y(), 0.0, 1e-13) << along << ", node " << i;
          expect_derivative(joint, joint.place({along + 1e-4, 0.0}, -1.0, 0.1), i);
          ++seen;
        }
        EXPECT_GE(seen, 4);
      }
}

TEST(NodeCondition, NodesThatRunPastTheMouthTakeTheirNeighboursTractions) {
  Joint joint(0.0);
  const Place place = joint.place({0.23, 0.0}, -1.0, 0.1);  // the lower face is bare up to 0.23: a bit before node 1
  const auto m = joint.at(place);
  EXPECT_TRUE(m.nodes()[0].supported);
  EXPECT_TRUE(m.nodes()[0].leans);
  EXPECT_TRUE(m.nodes()[1].leans);
  EXPECT_FALSE(m.nodes()[kNode].leans);
  for (const Index node : {0, 1}) expect_derivative(joint, place, node);

  const Place further = joint.place({0.26, 0.0}, -1.0, 0.1);
  const auto gone = joint.at(further);
  EXPECT_FALSE(gone.nodes()[0].supported);
  const double difference = further.tractions[0] - further.tractions[2];
  EXPECT_NEAR(gone.conditions()[0].value.x(), -0.25 / 12.0 * difference, 1e-12) << "zero if they are the same";
  for (const Index node : {0, 1}) expect_derivative(joint, further, node);
}

TEST(NodeCondition, FaceWithNothingOppositeBearsNothing) {
  Joint joint;
  const Place place = joint.place({0.0, 20.0}, -1.0, 0.1);
  const auto m = joint.at(place);
  for (Index i = 0; i < joint.nodes(); ++i) {
    const Vec2 own = joint.surfaces.multiplier_space.nodes[i].length * place.tractions.segment<2>(2 * i);
    EXPECT_EQ(m.nodes()[i].status, Status::Open);
    EXPECT_NEAR((m.conditions()[i].value - own).norm(), 0.0, 1e-14);
    expect_derivative(joint, place, i);
  }
}

TEST(NodeCondition, FacesThatBothCarryHatsAreTiedToEachOthersTractions) {
  Joint joint(2.0, NegativeSide::Both);
  Place place = joint.place({1e-5, -2e-5}, -1.0, 0.1);
  place.tractions[2 * kNode] -= 0.05;
  const auto m = joint.at(place);
  const auto& node = m.nodes()[kNode];
  EXPECT_EQ(node.status, Status::Stick);
  EXPECT_LT(node.beyond.x(), -0.5 * 0.125 * 0.05) << "it presses more than the other face";
  for (const Index k : {kNode, kNode + joint.nodes() / 2}) expect_derivative(joint, place, k);
}

// The upper block has slid by 0.11: what it bears there, between its nodes.
TEST(NodeCondition, NodeIsTiedToWhatTheOtherFaceBearsOppositeIt) {
  Joint joint(2.0, NegativeSide::Both);
  const double along = 0.11;
  const Place place = joint.place({along, 0.0}, -1.0, 0.1);
  const auto m = joint.at(place);
  const auto& space = joint.surfaces.multiplier_space;
  int seen = 0;
  for (Index i = 0; i < joint.nodes(); ++i) {
    const auto& node = space.nodes[i];
    const bool upper = node.side == geometry::Side::Left;
    // beyond the end of the other face it is what the end bears
    const double there = std::clamp(node.s + (upper ? along : -along), 0.0, 1.0);
    Vec2 expected = Vec2::Zero();
    for (Index j = 0; j < joint.nodes(); ++j) {
      const double hat = std::max(0.0, 1.0 - std::fabs(space.nodes[j].s - there) / 0.25);
      if (space.nodes[j].side != node.side) expected += hat * Vec2(place.tractions[2 * j], -place.tractions[2 * j + 1]);
    }
    const auto& facing = m.facing()[i];
    ASSERT_NE(facing.mortar_pair, kNone);
    EXPECT_LT((facing.traction - expected).norm(), 1e-12) << i;
    EXPECT_NEAR(m.nodes()[i].reach, m.nodes()[i].support, 1e-14) << "nothing is stretched";
    EXPECT_EQ(facing.place.by.isZero(0.0), there == 0.0 || there == 1.0) << i;
    seen += there == 0.0 || there == 1.0;
    expect_derivative(joint, place, i);
  }
  EXPECT_EQ(seen, 2);
}

TEST(NodeCondition, NodeAtAVertexFacesTheSamePlaceInAReversedCrack) {
  // Nodes lie at vertices of both faces here: the spacing is a multiple of the elements.
  Joint joint(2.0, NegativeSide::Both);
  const auto m = joint.at(joint.place({0.1, 0.0}, -1.0, 0.1));
  const auto& space = joint.surfaces.multiplier_space;
  int judged = 0;
  for (Index i = 0; i < joint.nodes(); ++i) {
    const auto& node = space.nodes[i];
    if (node.s < 0.2 || node.s > 0.8) continue;
    const auto& face =
        joint.surfaces.faces[space.interval_parts[m.mortar_pairs()[m.facing()[i].mortar_pair].interval_part].face];
    // seen along the body's own boundary, on either side of the crack: the segment on the same hand
    EXPECT_NEAR(node.side == geometry::Side::Left ? face.s_start : face.s_end, node.s, 1e-12);
    ++judged;
  }
  EXPECT_EQ(judged, 6);
}

}  // namespace
}  // namespace cleft::contact
