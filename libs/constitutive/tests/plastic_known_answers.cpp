// Closed forms at a point: simple shear, uniaxial stress and strain, steady flow of a cone.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "plastic_cases.hpp"

namespace cleft::constitutive {
namespace {

// Out of reach of any yield.
FinitePlastic strong(double young, double poisson) { return {{lame(young, poisson), 1e9 * young, 0.0, 0.0, 0.0}}; }

Mat2 cauchy_at(const FinitePlastic& law, const Mat2& F) {
  PlasticState updated;
  return cauchy(law.respond(F, {}, updated).piola, F);
}

TEST(FinitePlasticKnownAnswer, ElasticSimpleShear) {
  for (const auto& [young, poisson] : {std::pair{1.0e4, 0.25}, std::pair{7.3e5, 0.41}}) {
    const FinitePlastic law = strong(young, poisson);
    const double mu = law.constants.mu;
    for (const double g : {1e-9, 0.03, 0.4, 2.0, 5.0}) {
      Mat2 F;
      F << 1, g, 0, 1;
      const Mat2 sigma = cauchy_at(law, F);
      const double s12 = 4 * mu * std::asinh(g / 2) / std::sqrt(4 + g * g), s11 = 0.5 * g * s12;
      EXPECT_NEAR(sigma(0, 1), s12, 1e-13 * s12);
      EXPECT_NEAR(sigma(0, 0), s11, 1e-13 * s12);
      EXPECT_NEAR(sigma(1, 1), -s11, 1e-13 * s12);
    }
  }
  Mat2 F;
  F << 1, 0.4, 0, 1;
  EXPECT_NEAR(cauchy_at(strong(1e4, 0.25), F)(0, 1), 1558.65346, 5e-6);
  F(0, 1) = 2.0;
  EXPECT_NEAR(cauchy_at(strong(1e4, 0.25), F)(0, 0), 4985.80192, 5e-6);
}

TEST(FinitePlasticKnownAnswer, ElasticUniaxialStressAndStrain) {
  for (const auto& [young, poisson, l] :
       {std::tuple{1.0e4, 0.25, 0.75}, std::tuple{2.0e6, 0.4, 1.9}, std::tuple{55.0, 0.0, 0.3}}) {
    const FinitePlastic law = strong(young, poisson);
    const double lateral = std::exp(-poisson / (1 - poisson) * std::log(l));
    Mat2 F = Vec2(l, lateral).asDiagonal();
    const Mat2 tau = det(F) * cauchy_at(law, F);
    EXPECT_NEAR(tau(0, 0), young / (1 - poisson * poisson) * std::log(l), 1e-13 * young);
    EXPECT_NEAR(tau(1, 1), 0.0, 1e-13 * young);
    F = Vec2(l, 1.0).asDiagonal();
    const Mat2 confined = l * cauchy_at(law, F);
    EXPECT_NEAR(confined(0, 0), uniaxial_strain_modulus(law.constants) * std::log(l), 1e-13 * young);
    EXPECT_NEAR(confined(1, 1), law.constants.lambda * std::log(l), 1e-13 * young);
  }
  const FinitePlastic law = strong(1e4, 0.25);
  const Mat2 F = Vec2(0.75, 1.1006424).asDiagonal(), confined = Vec2(0.75, 1.0).asDiagonal();
  EXPECT_NEAR(cauchy_at(law, F)(0, 0), -3717.3548, 2e-3);  // lateral stretch rounded
  EXPECT_NEAR(0.75 * cauchy_at(law, confined)(1, 1), -1150.7283, 5e-5);
}

// Principal stresses in the plane (Kirchhoff at finite strain) and beside it.
struct Principal {
  double axial, lateral, normal;
};

// Strained along x in equal logarithmic steps, free along y: Newton's method on the lateral stretch.
template <class Law>
Principal unconfined(const Law& law, double step_size, int steps) {
  PlasticState committed, updated;
  double axial = 1.0, lateral = 1.0;
  Mat2 F = Mat2::Identity(), tau = Mat2::Zero();
  for (int k = 0; k < steps; ++k) {
    axial = std::is_same_v<Law, FinitePlastic> ? axial * std::exp(step_size) : axial + step_size;
    for (int iteration = 0; iteration < 60; ++iteration) {
      F = Vec2(axial, lateral).asDiagonal();
      const Response r = law.respond(test::at(law, F), committed, updated);
      tau = test::stress(law, r, F);
      const double correction = -r.piola(1, 1) / r.tangent(3, 3);
      if (std::abs(correction) <= 1e-15 * std::abs(lateral)) break;
      lateral += correction;
    }
    committed = updated;
  }
  return {tau(0, 0), tau(1, 1), law.out_of_plane_stress(test::at(law, F), committed)};
}

struct SteadyFlow {
  DruckerPrager material;
  double tension, compression;  // unconfined strengths in plane strain, Pa; 0: from the formula only
};

// In steady flow no elastic strain changes, so the plastic strain has no out-of-plane part: s_33 = -b/3 |s|. In the
// plane that leaves a Mohr-Coulomb line, radius k (alpha - beta p_m)/D, with k = sqrt((1 - b^2/6)/2) and D = 1 - beta
// b/6.
template <class Law>
void expect_steady_flow(const SteadyFlow& flow, double step_size, int steps, double tolerance) {
  const auto& [m, tension, compression] = flow;
  const double b = m.dilatancy, k = std::sqrt((1 - b * b / 6) / 2), D = 1 - m.friction * b / 6;
  const double root = m.friction * k / D, cohesive = 2 * k * m.cohesion / D;
  for (const double sign : {1.0, -1.0}) {
    const Principal s = unconfined(Law{m}, sign * step_size, steps);
    const double strength = cohesive / (1 + sign * root);
    EXPECT_NEAR(s.lateral, 0.0, tolerance * strength);
    EXPECT_NEAR(s.axial, sign * strength, tolerance * strength);
    const double p = (s.axial + s.lateral + s.normal) / 3;
    const double norm = std::hypot(s.axial - p, s.lateral - p, s.normal - p);
    EXPECT_NEAR((s.normal - p) / norm, -b / 3, tolerance);
    const double known = sign > 0 ? tension : compression;
    if (known > 0) {
      EXPECT_NEAR(strength, known, 1e-5 * known);
    }
  }
}

TEST(SmallPlasticKnownAnswer, SteadyFlowHasTheMohrCoulombStrength) {
  expect_steady_flow<SmallPlastic>({{lame(1e10, 0.25), 1.5e9, 0.8, 0.7, 0.0}, 1403.17e6, 5576.0e6}, 0.2, 100, 1e-12);
  expect_steady_flow<SmallPlastic>({{lame(3e6, 0.4), 2e4, 0.45, 0.1, 0.0}, 0, 0}, 0.002, 200, 1e-12);
}

TEST(FinitePlasticKnownAnswer, SteadyFlowHasTheMohrCoulombStrength) {
  expect_steady_flow<FinitePlastic>({{lame(1e10, 0.25), 1.5e7, 0.8, 0.7, 0.0}, 1403.17e4, 5576.0e4}, 0.004, 100, 1e-10);
  expect_steady_flow<FinitePlastic>({{lame(3e6, 0.4), 2e4, 0.45, 0.1, 0.0}, 0, 0}, 0.002, 200, 1e-10);
}

// The strong rock of the S-shaped crack: |s| < alpha - beta p has no unconfined compressive strength, since beta k > D.
TEST(SmallPlasticKnownAnswer, SteepConeYieldsInTensionOnly) {
  const SmallPlastic law{{lame(1e10, 0.3), 3e9, 1.2, 1.0, 0.0}};
  const double k = std::sqrt((1 - 1.0 / 6) / 2), D = 1 - 1.2 / 6;
  EXPECT_NEAR(std::asin(1.2 * k / D) * 180 / std::numbers::pi, 75.5, 0.05);
  const double strength = 2 * k * 3e9 / D / (1 + 1.2 * k / D);
  EXPECT_NEAR(unconfined(law, 0.3, 100).axial, strength, 1e-11 * strength);
  PlasticState updated;  // equal biaxial extension goes to the apex, 2500 MPa
  const Response r = law.respond(Mat2(Vec2(0.9, 0.9).asDiagonal()), {}, updated);
  EXPECT_NEAR(r.piola(0, 0), 2.5e9, 1e-3);
  EXPECT_NEAR(law.out_of_plane_stress(Mat2(Vec2(0.9, 0.9).asDiagonal()), updated), 2.5e9, 1e-3);
}

// |s| = sqrt2 |tau| while the elastic part is in proportion, so that one step and many end alike.
TEST(SmallPlasticKnownAnswer, HardeningJ2InSimpleShear) {
  const double yield = 235.0, h = 2100.0;
  const SmallPlastic law{von_mises(lame(2.1e5, 0.3), yield, h)};
  const double mu = law.constants.mu;
  PlasticState committed, updated;
  for (int k = 1; k <= 20; ++k) {
    const double shear = 0.001 * k;  // engineering shear strain
    Mat2 H;
    H << 0, shear, 0, 0;
    const Response r = law.respond(H, committed, updated);
    const double first = yield / std::sqrt(3.0),
                 modulus = h / 3.0;  // of the shear stress over plastic engineering shear
    const double expected = mu * shear <= first ? mu * shear : (first + modulus * shear) / (1 + modulus / mu);
    EXPECT_NEAR(r.piola(0, 1), expected, 1e-11 * yield);
    committed = updated;
  }
}

// Rigid-plastic simple shear at finite strain: with a small elastic range the Kirchhoff shear stress stays
// sigma_y/sqrt3.
TEST(FinitePlasticKnownAnswer, PerfectJ2InLargeSimpleShear) {
  const double yield = 1.0;
  const FinitePlastic law{von_mises(lame(1e6, 0.3), yield)};
  PlasticState committed, updated;
  for (int k = 1; k <= 300; ++k) {
    Mat2 F;
    F << 1, 0.01 * k, 0, 1;
    const Mat2 sigma = cauchy(law.respond(F, committed, updated).piola, F);
    EXPECT_NEAR(sigma(0, 1), yield / std::sqrt(3.0), 2e-5);
    committed = updated;
  }
  EXPECT_NEAR(committed.accumulated, 3.0 / std::sqrt(2.0), 1e-4);
}

}  // namespace
}  // namespace cleft::constitutive
