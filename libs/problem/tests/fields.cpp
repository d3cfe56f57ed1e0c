// Registered fields: equilibrium, jumps over their cracks, and what a side asks for.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "cleft/problem/field.hpp"

namespace cleft::problem {
namespace {

using geometry::MaybeSide;
using geometry::Side;

constexpr double kYoung = 2e9, kPoisson = 0.3;
const constitutive::Lame kSteel = constitutive::lame(kYoung, kPoisson);

FieldSpec spec(const std::string& name, const std::map<std::string, double>& parameters = {}) {
  FieldSpec out;
  out.name = name;
  out.parameters = parameters;
  return out;
}
Field field(const std::string& name, const std::map<std::string, double>& parameters) {
  return make_field(spec(name, parameters), kSteel);
}

Mat2 stress(const Field& f, const Vec2& X, MaybeSide side, double step) {
  const Mat2 g = field_gradient(f, X, side, step), e = 0.5 * (g + g.transpose());
  return kSteel.lambda * e.trace() * Mat2::Identity() + 2.0 * kSteel.mu * e;
}

Vec2 divergence(const Field& f, const Vec2& X, MaybeSide side) {
  const double step = 1e-3;
  Vec2 out = Vec2::Zero();
  for (int j = 0; j < 2; ++j) {
    const Vec2 d = step * Vec2::Unit(j);
    out += (stress(f, X + d, side, step) - stress(f, X - d, side, step)).col(j) / (2.0 * step);
  }
  return out;
}

// Points on a crack that runs into (0.2, 0.1) at 30 degrees, off it by rounding.
const std::map<std::string, double> kTip{{"tip_x", 0.2}, {"tip_y", 0.1}, {"angle", 30.0}, {"K", 3e6}};
const Vec2 kAlong(std::cos(std::numbers::pi / 6), 0.5), kLeft(-0.5, std::cos(std::numbers::pi / 6));
Vec2 behind(double r) { return Vec2(0.2, 0.1) - r * kAlong; }

TEST(NearTipField, JumpsOnItsFacesByTheClosedFormWhateverRoundingMakesOfAPoint) {
  for (const double r : {0.01, 0.37, 1.9})
    for (const double off : {0.0, 1e-16, -1e-16}) {
      const double jump = 8.0 * (1.0 - kPoisson * kPoisson) / kYoung * 3e6 * std::sqrt(r / (2.0 * std::numbers::pi));
      const Vec2 X = behind(r) + off * kLeft;
      const Field opens = field("mode-I", kTip), slides = field("mode-II", kTip);
      EXPECT_LT((opens(X, Side::Left) - opens(X, Side::Right) - jump * kLeft).norm(), 1e-9 * jump);
      EXPECT_LT((slides(X, Side::Left) - slides(X, Side::Right) - jump * kAlong).norm(), 1e-9 * jump);
    }
}

TEST(NearTipField, SolvesLinearElasticityOnEachSideAndBeyondIt) {
  for (const char* mode : {"mode-I", "mode-II"})
    for (const MaybeSide side : {MaybeSide{}, MaybeSide{Side::Left}, MaybeSide{Side::Right}})
      for (const double height : {0.3, -0.3}) {
        const Field f = field(mode, kTip);
        const Vec2 X = behind(0.8) + height * kLeft;
        // third derivatives of the field make an error of step^2 over the distance squared, times stress over distance
        EXPECT_LT(divergence(f, X, side).norm(), 1e-5 * stress(f, X, side, 1e-3).norm());
      }
}

TEST(NearTipField, HasFacesFreeOfTraction) {
  for (const char* mode : {"mode-I", "mode-II"})
    for (const Side side : {Side::Left, Side::Right}) {
      const Mat2 s = stress(field(mode, kTip), behind(0.8), side, 1e-3);
      EXPECT_LT((s * kLeft).norm(), 1e-8 * 3e6);
    }
}

// A crack at 30 degrees through (0.2, 0.1), pressed, with a half-length of 0.7.
std::map<std::string, double> closed(double tau, double friction) {
  return {{"center_x", 0.2}, {"center_y", 0.1}, {"angle", 30.0},       {"half_length", 0.7},
          {"sigma_n", -3e6}, {"tau", tau},      {"friction", friction}};
}
constexpr double kPressure = 3e6;
Vec2 on_crack(double x) { return Vec2(0.2, 0.1) + x * kAlong; }

TEST(ClosedCrackField, SlipsByTheEllipseOfTheShearThatFrictionLeaves) {
  for (const double sign : {1.0, -1.0})
    for (const double x : {-0.69, -0.2, 0.0, 0.5})
      for (const double off : {0.0, 1e-16, -1e-16}) {
        const Field f = field("closed-crack", closed(sign * 2e6, 0.4));
        const double slip =
            sign * 4.0 * (1.0 - kPoisson * kPoisson) / kYoung * (2e6 - 0.4 * kPressure) * std::sqrt(0.49 - x * x);
        const Vec2 X = on_crack(x) + off * kLeft;
        EXPECT_LT((f(X, Side::Left) - f(X, Side::Right) - slip * kAlong).norm(), 1e-12 * std::fabs(slip));
      }
}

TEST(ClosedCrackField, CarriesPressureAndFrictionOnBothFaces) {
  for (const double sign : {1.0, -1.0})
    for (const auto side : {Side::Left, Side::Right}) {
      const Mat2 s = stress(field("closed-crack", closed(sign * 2e6, 0.4)), on_crack(0.3), side, 1e-3);
      EXPECT_NEAR(kLeft.dot(s * kLeft), -kPressure, 1e-6 * kPressure);
      EXPECT_NEAR(kAlong.dot(s * kLeft), sign * 0.4 * kPressure, 1e-6 * kPressure);
    }
}

TEST(ClosedCrackField, SolvesLinearElasticityOnEachSideBeyondItAndAheadOfItsTips) {
  const Field f = field("closed-crack", closed(2e6, 0.4));
  for (const MaybeSide side : {MaybeSide{}, MaybeSide{Side::Left}, MaybeSide{Side::Right}})
    for (const double height : {0.3, -0.3})
      for (const double x : {-1.3, -0.4, 0.2, 1.1})
        EXPECT_LT(divergence(f, on_crack(x) + height * kLeft, side).norm(), 1e-4 * kPressure) << x << " " << height;
}

TEST(ClosedCrackField, HasTheRemoteStressFarAwayAndEverywhereWhereItSticks) {
  const auto expect_remote = [](const Field& f, const Vec2& X, double tau, double tolerance) {
    const Mat2 s = stress(f, X, {}, 1e-3 * X.norm());
    EXPECT_NEAR(kLeft.dot(s * kLeft), -kPressure, tolerance * kPressure);
    EXPECT_NEAR(kAlong.dot(s * kLeft), tau, tolerance * kPressure);
    EXPECT_NEAR(kAlong.dot(s * kAlong), 0.0, tolerance * kPressure);
  };
  // the crack's own stress falls with the square of the distance
  for (const Vec2& X : {Vec2(300, 0), Vec2(-200, 200), Vec2(0, -300)})
    expect_remote(field("closed-crack", closed(2e6, 0.4)), X, 2e6, 1e-5);
  for (const double tau : {1.19e6, -1.19e6})
    for (const Vec2& X : {Vec2(1, 2), Vec2(0.3, 0.15), Vec2(-0.5, 0.2)})
      expect_remote(field("closed-crack", closed(tau, 0.4)), X, tau, 1e-9);
}

TEST(ClosedCrackField, RefusesWhatIsNoClosedCrack) {
  for (const auto& [key, value] : {std::pair{"sigma_n", 1.0}, {"half_length", 0.0}, {"friction", -0.1}}) {
    auto parameters = closed(2e6, 0.4);
    parameters[key] = value;
    EXPECT_THROW(field("closed-crack", parameters), InputError) << key;
  }
}

// The same crack, pulled open.
const std::map<std::string, double> kOpened{{"center_x", 0.2}, {"center_y", 0.1}, {"angle", 30.0}, {"half_length", 0.7},
                                            {"sigma_n", 3e6},  {"tau", -2e6},     {"sigma_t", 1e6}};

TEST(OpenCrackField, OpensAndSlidesByTheEllipseOfTheRemoteTraction) {
  for (const double x : {-0.69, -0.2, 0.0, 0.5})
    for (const double off : {0.0, 1e-16, -1e-16}) {
      const Field f = field("open-crack", kOpened);
      const double jump = 4.0 * (1.0 - kPoisson * kPoisson) / kYoung * std::sqrt(0.49 - x * x);
      const Vec2 X = on_crack(x) + off * kLeft, exact = jump * (3e6 * kLeft - 2e6 * kAlong);
      EXPECT_LT((f(X, Side::Left) - f(X, Side::Right) - exact).norm(), 1e-12 * exact.norm());
    }
}

TEST(OpenCrackField, HasFacesFreeOfTraction) {
  for (const auto side : {Side::Left, Side::Right})
    for (const double x : {-0.4, 0.0, 0.3}) {
      const Mat2 s = stress(field("open-crack", kOpened), on_crack(x), side, 1e-3);
      EXPECT_LT((s * kLeft).norm(), 1e-6 * 3e6) << x;
    }
}

TEST(OpenCrackField, SolvesLinearElasticityOnEachSideBeyondItAndAheadOfItsTips) {
  const Field f = field("open-crack", kOpened);
  for (const MaybeSide side : {MaybeSide{}, MaybeSide{Side::Left}, MaybeSide{Side::Right}})
    for (const double height : {0.3, -0.3})
      for (const double x : {-1.3, -0.4, 0.2, 1.1})
        EXPECT_LT(divergence(f, on_crack(x) + height * kLeft, side).norm(), 1e-4 * 3e6) << x << " " << height;
}

TEST(OpenCrackField, HasTheRemoteStressFarAway) {
  for (const Vec2& X : {Vec2(300, 0), Vec2(-200, 200), Vec2(0, -300)}) {
    const Mat2 s = stress(field("open-crack", kOpened), X, {}, 1e-3 * X.norm());
    EXPECT_NEAR(kLeft.dot(s * kLeft), 3e6, 1e-5 * 3e6);
    EXPECT_NEAR(kAlong.dot(s * kLeft), -2e6, 1e-5 * 3e6);
    EXPECT_NEAR(kAlong.dot(s * kAlong), 1e6, 1e-5 * 3e6);
  }
}

// sqrt(2 pi r) times the stress ahead of a tip is K up to terms of r / a.
TEST(OpenCrackField, HasItsStressIntensityAheadOfBothTips) {
  const double r = 1e-4, root = std::sqrt(2.0 * std::numbers::pi * r), unit = std::sqrt(std::numbers::pi * 0.7);
  for (const double end : {-1.0, 1.0}) {
    const Mat2 s = stress(field("open-crack", kOpened), on_crack(end * (0.7 + r)), {}, 1e-3 * r);
    EXPECT_NEAR(root * kLeft.dot(s * kLeft), 3e6 * unit, 1e-3 * 3e6 * unit);
    EXPECT_NEAR(root * kAlong.dot(s * kLeft), -2e6 * unit, 1e-3 * 3e6 * unit);
  }
}

TEST(OpenCrackField, RefusesACrackThatDoesNotOpen) {
  for (const auto& [key, value] : {std::pair{"sigma_n", 0.0}, {"sigma_n", -1.0}, {"half_length", 0.0}}) {
    auto parameters = kOpened;
    parameters[key] = value;
    EXPECT_THROW(field("open-crack", parameters), InputError) << key;
  }
}

TEST(PartedWaves, AreTwoFieldsAnOpeningApartAndThePlaceDecidesOnlyWithoutASide) {
  const std::map<std::string, double> parameters{{"a", 0.02}, {"k", 2.0},      {"x", 0.3},
                                                 {"y", 0.4},  {"angle", 30.0}, {"opening", 0.5}};
  const Field parted = field("parted-waves", parameters), whole = field("waves", {{"a", 0.02}, {"k", 2.0}});
  const Vec2 on_line = Vec2(0.3, 0.4) + 0.7 * kAlong;
  for (const double height : {0.1, -0.1}) {
    const Vec2 X = on_line + height * kLeft;
    EXPECT_EQ(parted(X, Side::Right), whole(X, {}));
    EXPECT_EQ(parted(X, {}), parted(X, height > 0.0 ? Side::Left : Side::Right));
    const Vec2 other = 0.02 * Vec2(std::cos(2 * X.x()) * std::sin(2 * X.y()), std::sin(X.x()) * std::cos(2 * X.y()));
    EXPECT_LT((parted(X, Side::Left) - other - 0.5 * kLeft).norm(), 1e-15);
  }
}

TEST(Fields, SayWhichLoadsTheyNeedAndWhichWayTheirCrackRuns) {
  EXPECT_EQ(loads_of(spec("mode-I")), FieldLoads::None);
  EXPECT_EQ(loads_of(spec("waves")), FieldLoads::Body);
  EXPECT_EQ(loads_of(spec("parted-waves")), FieldLoads::BodyAndFaces);
  EXPECT_FALSE(crack_direction_of(spec("waves")));
  EXPECT_LT((*crack_direction_of(spec("mode-II", kTip)) - kAlong).norm(), 1e-15);
  EXPECT_EQ(*crack_direction_of(spec("mode-II")), Vec2::UnitX());
}

}  // namespace
}  // namespace cleft::problem
