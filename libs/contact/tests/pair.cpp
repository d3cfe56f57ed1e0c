#include "cleft/contact/pair.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace cleft::contact {
namespace {

using Inputs = Eigen::Matrix<double, kPairInputs, 1>;

Inputs pack(const PairPoints& p) {
  Inputs v;
  v << p.negative_start, p.negative_end, p.positive_start, p.positive_end, p.anchor, p.mouth;
  return v;
}

PairPoints unpack(const Inputs& v) {
  return {v.segment<2>(0), v.segment<2>(2), v.segment<2>(4), v.segment<2>(6), v.segment<2>(8), v.segment<2>(10)};
}

PairConstants constants(double sign) {
  PairConstants c;
  c.law = Coulomb{0.3};
  c.springs = {3.0, 2.0};
  c.touch = {1e-14};
  c.weight = 0.7;
  c.eta = 0.21;
  c.share_begin = 0.0;
  c.share_end = 0.5;
  c.normal_sign = sign;
  c.anchored = true;
  return c;
}

// A tilted, stretched pair that penetrates by about 0.05, with the anchor at the given distance along the tangent.
PairPoints points(double angle, double sign, double anchor_along, double mouth_along) {
  Mat2 turn;
  turn << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  const Vec2 n(0.0, sign);
  const PairPoints p{Vec2(0.0, 0.0),
                     Vec2(1.1, 0.1 * sign),
                     Vec2(-0.4, 0.02 * sign) - 0.1 * n,
                     Vec2(0.9, 0.17 * sign) - 0.1 * n,
                     Vec2(0.23 + anchor_along, 0.0),
                     Vec2(0.23 + mouth_along, 0.03)};
  return {turn * p.negative_start, turn * p.negative_end, turn * p.positive_start,
          turn * p.positive_end,   turn * p.anchor,       turn * p.mouth};
}

double tangent_error(const PairPoints& p, const PairConstants& c) {
  const PairForce exact = force(p, c, evaluate(p, c));
  const double h = 1e-6;
  double worst = 0.0;
  for (int k = 0; k < kPairInputs; ++k) {
    Inputs up = pack(p), down = pack(p);
    up[k] += h;
    down[k] -= h;
    const PairPoints pu = unpack(up), pd = unpack(down);
    const Eigen::Matrix<double, kPairOutputs, 1> d =
        (force(pu, c, evaluate(pu, c)).force - force(pd, c, evaluate(pd, c)).force) / (2 * h);
    worst = std::max(worst, (d - exact.tangent.col(k)).cwiseAbs().maxCoeff() / exact.tangent.cwiseAbs().maxCoeff());
  }
  return worst;
}

struct Branch {
  const char* name;
  double anchor_along, mouth_along;
  int mouth;
  bool anchored;
  Status status;
};

class ContactPair : public testing::TestWithParam<Branch> {};

TEST_P(ContactPair, TangentIsTheDerivativeOfTheForce) {
  const Branch& b = GetParam();
  struct Case {
    InterfaceLaw law;
    double sign, angle;
  };
  std::vector<Case> cases;
  for (const InterfaceLaw& law : {InterfaceLaw(Coulomb{0.3}), InterfaceLaw(LimitedCoulomb{0.3, 0.05})})
    for (const double sign : {1.0, -1.0})
      for (const double angle : {0.0, 0.7, 2.5}) cases.push_back({law, sign, angle});
  for (const auto& [law, sign, angle] : cases) {
    PairConstants c = constants(sign);
    c.law = law;
    c.mouth = b.mouth;
    c.anchored = b.anchored;
    const PairPoints p = points(angle, sign, b.anchor_along, b.mouth_along);
    const PairState s = evaluate(p, c);
    ASSERT_EQ(s.traction.status, b.status);
    if (b.mouth != 0) {
      ASSERT_TRUE(s.ramp > 0.1 && s.ramp < 0.9) << s.ramp;
    }
    EXPECT_LT(tangent_error(p, c), 1e-8) << b.name;
  }
}

TEST_P(ContactPair, ForcesAndTheirMomentsAddUpToNothing) {
  const Branch& b = GetParam();
  for (const double sign : {1.0, -1.0}) {
    PairConstants c = constants(sign);
    c.mouth = b.mouth;
    c.anchored = b.anchored;
    const PairPoints p = points(0.3, sign, b.anchor_along, b.mouth_along);
    const PairState s = evaluate(p, c);
    const auto f = force(p, c, s).force;
    const std::array<Vec2, 4> at{p.negative_start, p.negative_end, p.positive_start, p.positive_end};
    Vec2 sum = Vec2::Zero();
    double moment = 0.0;
    for (int k = 0; k < 4; ++k) {
      sum += f.segment<2>(2 * k);
      moment += cross(at[k], f.segment<2>(2 * k));
    }
    EXPECT_LT(sum.norm(), 1e-15 + 1e-14 * f.norm());
    EXPECT_LT(std::fabs(moment), 1e-15 + 1e-14 * f.norm()) << "a rigid turn must do no work";
    EXPECT_GT(f.norm(), 0.01);
  }
}

INSTANTIATE_TEST_SUITE_P(Branches, ContactPair,
                         testing::Values(Branch{"stick", 0.001, 0.0, 0, true, Status::Stick},
                                         Branch{"slip", 0.5, 0.0, 0, true, Status::Slip},
                                         Branch{"slip back", -0.5, 0.0, 0, true, Status::Slip},
                                         Branch{"first touch", 0.0, 0.0, 0, false, Status::Stick},
                                         Branch{"stick at the mouth", 0.001, 0.05, 1, true, Status::Stick},
                                         Branch{"slip at the mouth", 0.5, 0.1, 1, true, Status::Slip},
                                         Branch{"slip at the other mouth", -0.5, 0.05, -1, true, Status::Slip}),
                         [](const auto& branch) {
                           std::string name = branch.param.name;
                           for (char& ch : name) ch = ch == ' ' ? '_' : ch;
                           return name;
                         });

TEST(PairForce, PushesThePenetratingBodiesApart) {
  const PairConstants c = constants(1.0);
  const PairPoints p = points(0.0, 1.0, 0.001, 0.0);
  const auto f = force(p, c, evaluate(p, c)).force;
  EXPECT_GT(f(1), 0.0);  // internal force on the negative face points along its outward normal: the load pushes it back
  EXPECT_LT(f(5), 0.0);
}

TEST(PairState, TurnsWithARigidRotation) {
  const PairConstants c = constants(-1.0);
  const PairState a = evaluate(points(0.0, -1.0, 0.2, 0.0), c), b = evaluate(points(1.9, -1.0, 0.2, 0.0), c);
  EXPECT_NEAR(a.normal_gap, b.normal_gap, 1e-15);
  EXPECT_NEAR(a.tangential_gap, b.tangential_gap, 1e-15);
  EXPECT_NEAR(a.partner, b.partner, 1e-14);
}

TEST(PairState, TheRampFallsFromOneToZeroWhileTheSharePassesTheMouth) {
  PairConstants c = constants(1.0);
  c.mouth = 1;  // the positive body lies ahead of its free end
  const double length = std::hypot(1.1, 0.1);
  double last = -1.0;
  for (const double along : {0.35, 0.2, 0.0, -0.1, -0.3}) {
    const double ramp = evaluate(points(0.0, 1.0, 0.0, along), c).ramp;
    EXPECT_GE(ramp, last);
    last = ramp;
  }
  EXPECT_EQ(evaluate(points(0.0, 1.0, 0.0, 0.36 * length), c).ramp, 0.0);
  EXPECT_EQ(last, 1.0);
}

}  // namespace
}  // namespace cleft::contact
