#include "cleft/enrichment/branch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace cleft::enrichment {
namespace {

using geometry::Side;
using geometry::TipFrame;

const TipFrame kStraight({{0.0, 0.0}, {-1.0, 0.0}}, Side::Left);
const TipFrame kBent({{0.0, 0.0}, {-0.2, 0.05}, {-0.5, -0.15}, {-0.9, -0.1}}, Side::Left);

Vec2 on_circle(double r, double phi) { return r * Vec2(std::cos(phi), std::sin(phi)); }

TEST(Branches, AreThoseOfAStraightCrack) {
  const double r = 0.37, t = 2.1;
  const auto f = branches(kStraight.at(on_circle(r, t))).value;
  EXPECT_NEAR(f[0], std::sqrt(r) * std::cos(t / 2), 1e-15);
  EXPECT_NEAR(f[1], std::sqrt(r) * std::sin(t / 2), 1e-15);
  EXPECT_NEAR(f[2], std::sqrt(r) * std::sin(t / 2) * std::sin(t), 1e-15);
  EXPECT_NEAR(f[3], std::sqrt(r) * std::cos(t / 2) * std::sin(t), 1e-15);
}

TEST(Branches, OnlyTheSecondJumps) {
  for (const double r : {0.05, 0.3, 0.7}) {
    const double s = 2.0 * 3.14159265358979323846;
    const double phi = 0.5 * s - kBent.at(on_circle(r, 0.5 * s)).angle;  // of the crack, up to a turn
    const Vec2 point = on_circle(r, 0.5 * s + std::remainder(phi, s));
    const auto left = branches(kBent.at(point, Side::Left)).value, right = branches(kBent.at(point, Side::Right)).value;
    for (const int a : {0, 2, 3}) EXPECT_NEAR(left[a], right[a], 1e-13);
    EXPECT_NEAR(left[1] - right[1], 2.0 * std::sqrt(r), 1e-13);
  }
}

TEST(Branches, GradientsAreTheDerivatives) {
  constexpr double kStep = 1e-6;
  for (const TipFrame* frame : {&kStraight, &kBent})
    for (const double r : {0.03, 0.15, 0.3, 0.8})
      for (const double phi : {-3.3, -3.0, -1.0, 0.2, 1.7, 3.05, 3.5})
        for (const geometry::MaybeSide side : {geometry::MaybeSide{}, {Side::Left}, {Side::Right}})
          for (const double blunting : {0.0, 0.02, 0.5}) {
            const Vec2 point = on_circle(r, phi);
            const Branches here = branches(frame->at(point, side), blunting);
            for (const int i : {0, 1}) {
              const Vec2 step = kStep * Vec2::Unit(i);
              const auto plus = branches(frame->at(point + step, side), blunting).value;
              const auto minus = branches(frame->at(point - step, side), blunting).value;
              for (int a = 0; a < kBranches; ++a)
                EXPECT_NEAR(here.gradient[a][i], (plus[a] - minus[a]) / (2 * kStep), 1e-7) << r << " " << phi;
            }
          }
}

TEST(Branches, BluntOnesHaveBoundedSlopesAndAreTheOthersAfar) {
  constexpr double kLength = 0.01;
  for (const double phi : {-3.0, -1.0, 0.2, 1.7, 3.05}) {
    double steepest = 0.0;
    for (double r = 1e-14; r < 1.0; r *= 2.0)
      for (const Vec2& slope : branches(kStraight.at(on_circle(r, phi)), kLength).gradient)
        steepest = std::max(steepest, slope.norm());
    EXPECT_LT(steepest, 2.0 / std::sqrt(kLength)) << phi;
    EXPECT_GT(branches(kStraight.at(on_circle(1e-14, phi))).gradient[1].norm(), 1e6) << phi;
    const auto sharp = branches(kStraight.at(on_circle(1.0, phi))).value;
    const auto blunt = branches(kStraight.at(on_circle(1.0, phi)), kLength).value;
    for (int a = 0; a < kBranches; ++a) EXPECT_NEAR(blunt[a], sharp[a], 0.5 * kLength) << phi;
  }
}

TEST(Branches, VanishAtTheTip) {
  const Branches at_tip = branches(kBent.at(Vec2::Zero(), Side::Left));
  for (int a = 0; a < kBranches; ++a) {
    EXPECT_EQ(at_tip.value[a], 0.0);
    EXPECT_EQ(at_tip.gradient[a].norm(), 0.0);
  }
}

TEST(Cutoff, FallsFromOneToNothingSmoothly) {
  EXPECT_EQ(cutoff(0.2, 0.2, 0.5).value, 1.0);
  EXPECT_EQ(cutoff(0.5, 0.2, 0.5).value, 0.0);
  EXPECT_NEAR(cutoff(0.35, 0.2, 0.5).value, 0.5, 1e-15);
  for (double r = 0.195; r < 0.51; r += 0.01) {
    const double step = 1e-6;
    const double slope = (cutoff(r + step, 0.2, 0.5).value - cutoff(r - step, 0.2, 0.5).value) / (2 * step);
    EXPECT_NEAR(cutoff(r, 0.2, 0.5).slope, slope, 1e-8);
    EXPECT_LE(slope, 0.0);
  }
}

}  // namespace
}  // namespace cleft::enrichment
