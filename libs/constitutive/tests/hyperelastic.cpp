#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "cleft/constitutive/hencky.hpp"
#include "cleft/constitutive/neo_hookean.hpp"

namespace cleft::constitutive {
namespace {

Mat2 rotation(double angle) {
  Mat2 r;
  r << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  return r;
}

template <class Material>
Material make(double young, double poisson) {
  return Material{lame(young, poisson)};
}

template <class Material>
class Hyperelastic : public testing::Test {};
using Materials = testing::Types<Hencky, NeoHookean>;
TYPED_TEST_SUITE(Hyperelastic, Materials);

TYPED_TEST(Hyperelastic, IsStressFreeAndLinearElasticAtIdentity) {
  const auto c = lame(1.0e10, 0.3);
  const Response r = TypeParam{c}.respond(Mat2::Identity());
  EXPECT_EQ(r.piola.norm(), 0.0);
  for (int i = 0; i < 2; ++i)
    for (int J = 0; J < 2; ++J)
      for (int k = 0; k < 2; ++k)
        for (int L = 0; L < 2; ++L) {
          const double exact = c.lambda * (i == J) * (k == L) + c.mu * ((i == k) * (J == L) + (i == L) * (J == k));
          EXPECT_NEAR(r.tangent(i + 2 * J, k + 2 * L), exact, 1e-15 * c.mu * 10);
        }
}

// Random deformations, among them pure rotations and nearly equal stretches (the branch of the series) and stretches
// far apart.
std::vector<Mat2> deformations() {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> angle(-3.1, 3.1), log_stretch(-0.9, 0.9);
  std::vector<Mat2> all;
  for (const double gap : {0.0, 1e-12, 1e-8, 1e-4, 1e-2, 0.2, 0.5, 1.5})
    for (int k = 0; k < 20; ++k) {
      const double l = std::exp(log_stretch(random));
      all.push_back(rotation(angle(random)) * Mat2(Vec2(l * std::exp(gap), l).asDiagonal()) * rotation(angle(random)));
    }
  return all;
}

TYPED_TEST(Hyperelastic, StressIsTheDerivativeOfTheEnergy) {
  const auto m = make<TypeParam>(2.5, 0.22);
  const double h = 1e-5;
  for (const Mat2& F : deformations()) {
    const Mat2 P = m.respond(F).piola;
    for (int i = 0; i < 2; ++i)
      for (int J = 0; J < 2; ++J) {
        Mat2 up = F, down = F;
        up(i, J) += h;
        down(i, J) -= h;
        EXPECT_NEAR((m.energy(up) - m.energy(down)) / (2 * h), P(i, J),
                    2e-8 * (1.0 + P.norm() + 1.0 / std::pow(det(F), 2)));
      }
  }
}

TYPED_TEST(Hyperelastic, TangentIsTheDerivativeOfTheStressInEveryBranch) {
  const auto m = make<TypeParam>(1.0e4, 0.25);
  const double h = 1e-5;
  for (const Mat2& F : deformations()) {
    const Mat4 D = m.respond(F).tangent;
    EXPECT_LT((D - D.transpose()).norm(), 1e-13 * D.norm());
    for (int k = 0; k < 2; ++k)
      for (int L = 0; L < 2; ++L) {
        Mat2 up = F, down = F;
        up(k, L) += h;
        down(k, L) -= h;
        const Mat2 difference = (m.respond(up).piola - m.respond(down).piola) / (2 * h);
        for (int i = 0; i < 2; ++i)
          for (int J = 0; J < 2; ++J)
            EXPECT_NEAR(difference(i, J), D(i + 2 * J, k + 2 * L), 2e-7 * D.row(i + 2 * J).cwiseAbs().maxCoeff());
      }
  }
}

TYPED_TEST(Hyperelastic, TurnsWithASuperposedRotation) {
  const auto m = make<TypeParam>(1.0e4, 0.25);
  const Mat2 R = rotation(1.1);
  for (const Mat2& F : deformations()) {
    const Mat2 once = R * m.respond(F).piola, turned = m.respond(R * F).piola;
    EXPECT_LT((once - turned).norm(), 1e-12 * (m.constants.mu + once.norm()));
  }
}

TEST(Hencky, SimpleShearHasTheClosedForm) {
  const auto m = make<Hencky>(1.0e4, 0.25);
  for (const auto& [g, s12, s11] : {std::tuple{0.4, 1558.65346, 311.73069}, std::tuple{2.0, 4985.80192, 4985.80192}}) {
    Mat2 F;
    F << 1, g, 0, 1;
    const Mat2 sigma = cauchy(m.respond(F).piola, F);
    EXPECT_NEAR(sigma(0, 1), 4 * 4000 * std::asinh(g / 2) / std::sqrt(4 + g * g), 1e-9);
    EXPECT_NEAR(sigma(0, 1), s12, 1e-5);
    EXPECT_NEAR(sigma(0, 0), s11, 1e-5);
    EXPECT_NEAR(sigma(1, 1), -s11, 1e-5);
  }
}

TEST(Hencky, SimpleShearSoftensBeyondAShearOfThree) {
  const auto m = make<Hencky>(7.0e5, 0.4);
  const auto shear_stress = [&](double g) {
    Mat2 F;
    F << 1, g, 0, 1;
    return cauchy(m.respond(F).piola, F)(0, 1);
  };
  double low = 2.5, high = 3.5;  // bisection of the slope; the maximum is where g asinh(g / 2) = sqrt(4 + g^2)
  for (int k = 0; k < 40; ++k) {
    const double middle = 0.5 * (low + high), h = 1e-4;
    (shear_stress(middle + h) > shear_stress(middle - h) ? low : high) = middle;
  }
  EXPECT_NEAR(low, 3.018, 5e-4);
}

TEST(Hencky, UniaxialStressAndStrainHaveTheClosedForm) {
  const double E = 1.0e4, nu = 0.25;
  const auto m = make<Hencky>(E, nu);
  const double lateral = std::exp(-nu / (1 - nu) * std::log(0.75));
  EXPECT_NEAR(lateral, 1.1006424, 1e-7);
  const Mat2 F = Vec2(0.75, lateral).asDiagonal();
  const Mat2 P = m.respond(F).piola;
  EXPECT_NEAR(P(0, 0), -4091.4784, 1e-4);
  EXPECT_NEAR(P(0, 0) * 0.75, E / (1 - nu * nu) * std::log(0.75), 1e-9);
  EXPECT_NEAR(P(1, 1), 0.0, 1e-9);
  EXPECT_NEAR(cauchy(P, F)(0, 0), -3717.3548, 1e-4);
  const Mat2 confined = Vec2(0.75, 1.0).asDiagonal();
  EXPECT_NEAR(m.respond(confined).piola(0, 0) * 0.75, -3452.1849, 1e-4);
  EXPECT_NEAR(m.respond(confined).piola(1, 1), -1150.7283, 1e-4);
}

TEST(SquaredLogRatio, IsContinuousWhereTheSeriesEnds) {
  const auto below = squared_log_ratio(0.1 * (1 - 1e-15)), above = squared_log_ratio(0.1);
  EXPECT_NEAR(below.value, above.value, 1e-14 * above.value);
  EXPECT_NEAR(below.first, above.first, 1e-14 * above.first);
  EXPECT_NEAR(below.second, above.second, 2e-14 * above.second);
  EXPECT_EQ(squared_log_ratio(0.0).first, 4.0);
}

TEST(NeoHookean, UniaxialStrainHasTheClosedForm) {
  const auto m = make<NeoHookean>(3.0e3, 0.35);
  const double l = 1.3;
  const Mat2 P = m.respond(Vec2(l, 1.0).asDiagonal()).piola;
  EXPECT_NEAR(P(0, 0), m.constants.mu * (l - 1 / l) + m.constants.lambda * std::log(l) / l, 1e-10);
  EXPECT_NEAR(P(1, 1), m.constants.lambda * std::log(l), 1e-10);
}

}  // namespace
}  // namespace cleft::constitutive
