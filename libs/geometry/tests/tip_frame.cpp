// Polar coordinates that follow a bent crack.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "cleft/geometry/tip.hpp"

namespace cleft::geometry {
namespace {

constexpr double kPi = std::numbers::pi;

const std::vector<Vec2> kBent{{0.1, 0.2}, {-0.2, 0.25}, {-0.4, 0.12}, {-0.9, 0.3}};  // from the tip outward

Vec2 on_circle(double r, double phi) { return kBent[0] + r * Vec2(std::cos(phi), std::sin(phi)); }

TEST(TipFrame, IsTheUsualOneForAStraightCrack) {
  const TipFrame frame({{1.0, 1.0}, {0.0, 1.0}}, Side::Left);
  EXPECT_LT((frame.ahead() - Vec2(1.0, 0.0)).norm(), 1e-15);
  for (const double t : {-3.1, -1.0, 0.0, 0.3, 2.0, 3.1}) {
    const TipPolar at = frame.at(Vec2(1.0, 1.0) + 0.3 * Vec2(std::cos(t), std::sin(t)));
    EXPECT_NEAR(at.r, 0.3, 1e-15);
    EXPECT_NEAR(at.angle, t, 1e-14);
  }
}

TEST(TipFrame, CrackIsAtPlusAndMinusPi) {
  for (const Side positive : {Side::Left, Side::Right}) {
    const TipFrame frame(kBent, positive);
    for (std::size_t k = 0; k + 1 < kBent.size(); ++k) {
      for (const double part : {0.01, 0.3, 0.9, 1.0}) {
        const Vec2 point = kBent[k] + part * (kBent[k + 1] - kBent[k]);
        EXPECT_NEAR(frame.at(point, positive).angle, kPi, 1e-13);
        EXPECT_NEAR(frame.at(point, other(positive)).angle, -kPi, 1e-13);
      }
    }
  }
}

TEST(TipFrame, AngleJumpsOnTheCrackOnly) {
  const TipFrame frame(kBent, Side::Left);
  for (const double r : {0.01, 0.25, 0.31, 0.45, 0.7}) {
    int jumps = 0;
    double before = frame.at(on_circle(r, 0.0)).angle;
    for (int k = 1; k <= 1000; ++k) {
      const double angle = frame.at(on_circle(r, 2.0 * kPi * k / 1000)).angle;
      if (std::abs(angle - before) > 0.01) {
        ++jumps;
        EXPECT_NEAR(before, kPi, 0.01);
        EXPECT_NEAR(angle, -kPi, 0.01);
      }
      before = angle;
    }
    EXPECT_EQ(jumps, 1);
  }
}

TEST(TipFrame, ASideContinuesOverTheCrack) {
  const TipFrame frame(kBent, Side::Left);
  for (const double r : {0.05, 0.35, 0.6}) {
    const double crack = kPi - frame.at(on_circle(r, kPi)).angle;  // turned by this much
    for (const double beyond : {-1.0, -1e-3, 1e-3, 1.0}) {
      const Vec2 point = on_circle(r, kPi + crack + beyond);
      EXPECT_NEAR(frame.at(point, Side::Left).angle, kPi + beyond, 1e-12);
      EXPECT_NEAR(frame.at(point, Side::Right).angle, -kPi + beyond, 1e-12);
      EXPECT_NEAR(frame.at(point).angle, beyond > 0.0 ? -kPi + beyond : kPi + beyond, 1e-12);
    }
  }
}

TEST(TipFrame, SideDoesNotMatterAhead) {
  const TipFrame frame(kBent, Side::Left);
  for (const double phi : {-1.0, 0.0, 1.0}) {
    const Vec2 point = on_circle(0.4, phi);
    EXPECT_EQ(frame.at(point, Side::Left).angle, frame.at(point).angle);
    EXPECT_EQ(frame.at(point, Side::Right).angle, frame.at(point).angle);
  }
}

TEST(TipFrame, GradientsAreTheDerivatives) {
  const TipFrame frame(kBent, Side::Left);
  constexpr double kStep = 1e-6;
  for (const double r : {0.05, 0.25, 0.35, 0.45, 0.8}) {
    for (const double phi : {-3.0, -2.0, 0.1, 1.5, 3.0, 3.4}) {
      for (const MaybeSide side : {MaybeSide{}, MaybeSide{Side::Left}, MaybeSide{Side::Right}}) {
        const Vec2 point = on_circle(r, phi);
        const TipPolar at = frame.at(point, side);
        for (const int i : {0, 1}) {
          const Vec2 step = kStep * Vec2::Unit(i);
          const TipPolar plus = frame.at(point + step, side), minus = frame.at(point - step, side);
          EXPECT_NEAR(at.r_gradient[i], (plus.r - minus.r) / (2 * kStep), 1e-8);
          EXPECT_NEAR(at.angle_gradient[i], (plus.angle - minus.angle) / (2 * kStep), 1e-6 / r) << r << " " << phi;
        }
      }
    }
  }
}

TEST(TipFrame, TipItselfIsTheOrigin) {
  const TipPolar at = TipFrame(kBent, Side::Left).at(kBent[0], Side::Left);
  EXPECT_EQ(at.r, 0.0);
  EXPECT_EQ(at.angle_gradient.norm(), 0.0);
}

}  // namespace
}  // namespace cleft::geometry
