#include "cleft/constitutive/localisation.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <numbers>

#include "cleft/constitutive/hencky.hpp"
#include "plastic_cases.hpp"

namespace cleft::constitutive {
namespace {

using test::between;

struct Scan {
  double lowest, size;
};

Scan scan(const Mat4& moduli) {
  Scan s{acoustic_determinant(moduli, 0.0), 0.0};
  for (int k = 0; k < 1800; ++k) {
    const double d = acoustic_determinant(moduli, 0.1 * k);
    s.lowest = std::min(s.lowest, d);
    s.size = std::max(s.size, std::abs(d));
  }
  return s;
}

// No direction of a scan is below the minimum found, and the minimum is attained.
RC_GTEST_PROP(WeakestDirection, IsBelowEveryDirectionOfAScan, ()) {
  std::mt19937 random(*rc::gen::arbitrary<unsigned>());
  const double tilt = *rc::gen::element(0.0, 1e-9, 1e-3, 1.0);  // from an isotropic to an arbitrary tangent
  const double young = between(random, 1, 10), poisson = between(random, 0, 0.45);
  Mat4 moduli = Hencky{lame(young, poisson)}.respond(Mat2::Identity()).tangent;
  for (int k = 0; k < 16; ++k) moduli(k) += tilt * between(random, -5, 5);
  const Localisation found = weakest_direction(moduli);
  const Scan s = scan(moduli);
  RC_ASSERT(found.angle >= 0.0);
  RC_ASSERT(found.angle < 180.0);
  // of directions alike within 1e-13 of the largest coefficient, twice the determinant of an isotropic tangent, the
  // first one is found
  RC_ASSERT(found.value <= s.lowest + 3e-13 * s.size);
  RC_ASSERT(found.value >= s.lowest - 2e-5 * s.size);  // the scan is that fine
  RC_ASSERT(std::abs(acoustic_determinant(moduli, found.angle) - found.value) <= 1e-12 * s.size);
}

// A turn of the axes turns the direction: also through the axes, where a chart ends, and the diagonals, where two meet.
TEST(WeakestDirection, TurnsWithTheMaterial) {
  std::mt19937 random(5);
  Mat4 moduli;
  for (int k = 0; k < 16; ++k) moduli(k) = between(random, -1, 1) + (k % 5 == 0 ? 4.0 : 0.0);
  const Localisation still = weakest_direction(moduli);
  for (int degree = 0; degree < 360; ++degree)
    for (const double offset :
         {0.0, 45.0 - still.angle, 90.0 - still.angle, 135.0 - still.angle, 180.0 - still.angle}) {
      const double angle = degree + offset;
      const Mat2 R = test::rotation(angle * std::numbers::pi / 180.0);
      Mat4 both;
      for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 2; ++j) both.block<2, 2>(2 * i, 2 * j) = R(i, j) * R;
      const Localisation turned = weakest_direction(both * moduli * both.transpose());
      EXPECT_NEAR(turned.value, still.value, 1e-12);
      const double difference = std::remainder(turned.angle - still.angle - angle, 180.0);
      EXPECT_NEAR(difference, 0.0, 1e-5);
    }
}

TEST(WeakestDirection, OfAnIsotropicTangentIsTheFirst) {
  const Lame c = lame(1e10, 0.3);
  const Localisation found = weakest_direction(Hencky{c}.respond(Mat2::Identity()).tangent);
  EXPECT_NEAR(found.value, uniaxial_strain_modulus(c) * c.mu, 1e-13 * found.value);
  EXPECT_EQ(found.angle, 0.0);
}

// A state of stress on the cone of given intermediate principal deviator N (over sqrt J2), out of the plane; the most
// tensile axis is at `axis` degrees. The plastic strain is arbitrary but for its part beside the plane.
struct OnTheCone {
  DruckerPrager material;
  Mat2 F;
  PlasticState state;
};

OnTheCone on_the_cone(DruckerPrager m, double N, double pressure_share, double axis) {
  const double accumulated = 0.01, strength = m.cohesion + m.hardening * accumulated;
  const double pressure = pressure_share * strength, shear = strength - m.friction * pressure;
  const double root_j2 = shear / std::sqrt(2.0);
  const double half = std::sqrt(1.0 - 0.75 * N * N);  // N_max,min = -N/2 +- half
  const double mu = m.constants.mu, turn = 2.0 * axis * std::numbers::pi / 180.0;
  const double mean_strain = pressure / (3.0 * bulk_modulus(m.constants));
  const PlaneTensor strain{mean_strain - 0.5 * N * root_j2 / (2 * mu),
                           half * root_j2 / (2 * mu) * Vec2(std::cos(turn), std::sin(turn)),
                           mean_strain + N * root_j2 / (2 * mu)};
  return {m, Mat2::Identity() + in_plane(strain), {{0.0, 0.0, 0.0, -strain.normal}, accumulated}};
}

double critical_hardening(const DruckerPrager& m, double nu, double N) {  // h_cr/G, Rudnicki and Rice
  const double mu_r = m.friction / std::numbers::sqrt2, beta_r = m.dilatancy / std::numbers::sqrt2;
  return (1 + nu) / (9 * (1 - nu)) * std::pow(beta_r - mu_r, 2) - (1 + nu) / 2 * std::pow(N + (beta_r + mu_r) / 3, 2);
}

double band_angle(const DruckerPrager& m, double nu, double N) {  // of the normal from the most tensile axis, degrees
  const double xi = (1 + nu) * (m.friction + m.dilatancy) / (3 * std::numbers::sqrt2) - N * (1 - nu);
  const double half = std::sqrt(1.0 - 0.75 * N * N);
  return 90.0 - std::atan(std::sqrt((xi + 0.5 * N + half) / (-0.5 * N + half - xi))) * 180.0 / std::numbers::pi;
}

// Their hardening modulus h belongs to sqrt(J2) over engineering plastic shear: H = 2 h. At H = 2 h_cr the minimum is
// zero, at the angle of the band.
TEST(Localisation, BeginsAtTheCriticalHardeningModulus) {
  struct Case {
    double nu, friction, dilatancy, N, critical, angle;
  };
  for (const Case& c :
       {Case{0.25, 0.8, 0.7, 0.0, -0.077199, 31.89}, Case{0.25, 0.8, 0.7, -0.2, -0.013811, 30.02},
        Case{0.4, 0.6, 0.1, 0.1, 0, 0}, Case{0.1, 1.1, 0.3, -0.3, 0, 0}, Case{0.3, 0.0, 0.0, 0.0, 0, 0}})
    for (const double axis : {0.0, 17.0, 45.0, 100.0}) {
      DruckerPrager m{lame(1e10, c.nu), 1.5e9, c.friction, c.dilatancy, 0.0};
      const double critical = critical_hardening(m, c.nu, c.N), angle = band_angle(m, c.nu, c.N);
      if (c.critical != 0) {
        EXPECT_NEAR(critical, c.critical, 1e-6);
        EXPECT_NEAR(angle, c.angle, 5e-3);
      }
      m.hardening = 2.0 * critical * m.constants.mu;
      const auto [material, F, state] = on_the_cone(m, c.N, -0.3, axis);
      const Localisation found = localisation(SmallPlastic{material}, F - Mat2::Identity(), state);
      EXPECT_NEAR(found.value, 0.0, 1e-12);
      // the mirror image of a band is one, too
      const double from_axis = std::abs(std::remainder(found.angle - axis, 180.0));
      EXPECT_NEAR(from_axis, angle, 1e-5);
      m.hardening += 1e-3 * m.constants.mu;
      const auto harder = on_the_cone(m, c.N, -0.3, axis);
      EXPECT_GT(localisation(SmallPlastic{m}, harder.F - Mat2::Identity(), harder.state).value, 1e-5);
    }
}

TEST(Localisation, OfPerfectPlasticityIsNegativeInAWindowOfStates) {
  const double nu = 0.25;
  const DruckerPrager m{lame(1e10, nu), 1.5e9, 0.9, 0.3, 0.0};
  const double mu_r = m.friction / std::numbers::sqrt2, beta_r = m.dilatancy / std::numbers::sqrt2;
  const double width = (mu_r - beta_r) * std::sqrt(2 / (9 * (1 - nu))), centre = -(mu_r + beta_r) / 3;
  const auto at = [&](double N) {
    const auto [material, F, state] = on_the_cone(m, N, 0.1, 30.0);
    return localisation(SmallPlastic{material}, F - Mat2::Identity(), state).value;
  };
  for (const double side : {-1.0, 1.0}) {
    EXPECT_LT(at(centre + side * width * 0.99), -1e-6);
    EXPECT_GT(at(centre + side * width * 1.01), 1e-6);
  }
}

// Small strains: the finite law has the same function, and its band turns with the body, by any angle. One step of a
// thousandth puts the state on its own cone, from which the linearised one is off by the square of the strain.
TEST(Localisation, OfFiniteStrainTendsToSmallStrainAndTurns) {
  const double axis = 20.0, turn = 60.0;
  const auto [m, F, state] = on_the_cone({lame(1e10, 0.25), 1e4, 0.8, 0.5, 0.0}, -0.2, -0.3, axis);
  const Localisation small = localisation(SmallPlastic{m}, F - Mat2::Identity(), state);
  const FinitePlastic law{m};
  PlasticState before = state, after;
  before.deformation[3] = std::expm1(-2.0 * state.deformation[3]);
  const Mat2 further = Mat2::Identity() + 1.001 * (F - Mat2::Identity());
  law.respond(further, before, after);
  const auto from_axis = [](double angle, double of) { return std::abs(std::remainder(angle - of, 180.0)); };
  const Localisation found = localisation(law, further, after);
  EXPECT_NEAR(found.value, small.value, 1e-3);
  EXPECT_NEAR(from_axis(found.angle, axis), from_axis(small.angle, axis), 0.1);
  const Localisation turned = localisation(law, test::rotation(turn * std::numbers::pi / 180.0) * further, after);
  EXPECT_NEAR(turned.value, found.value, 1e-9);
  EXPECT_NEAR(from_axis(turned.angle, axis + turn), from_axis(found.angle, axis), 1e-5);
}

// |s| over the cohesion
template <class Law>
double shear_strength_left(const Law& law, const Mat2& F, const PlasticState& state) {
  PlasticState updated;
  const Mat2 in_plane = test::stress(law, law.respond(test::at(law, F), state, updated), F);
  const PlaneTensor s = deviator(
      plane_tensor(in_plane(0, 0), in_plane(1, 1), in_plane(0, 1), law.out_of_plane_stress(test::at(law, F), state)));
  return std::sqrt(contract(s, s)) / law.cohesion;
}

// The rate of the continued flow is what the algorithmic tangent tends to as the step shrinks.
template <class Law>
void expect_continuum_is_the_limit_of_small_steps() {
  int compared = 0;
  for (const auto& [name, material] : test::materials()) {
    const Law law{material};
    for (const test::Step& step : test::steps(law, 20)) {
      PlasticState at_end, updated;
      law.respond(test::at(law, step.F), step.committed, at_end);
      const ContinuumTangent continuum = law.continuum_tangent(test::at(law, step.F), at_end);
      if (at_end.accumulated == step.committed.accumulated || continuum.branch == Branch::Apex) continue;
      if (shear_strength_left(law, step.F, at_end) < 0.01) continue;  // next to the apex no step is small
      // a minute step on from there that loads
      const Mat2 tau = test::stress(law, law.respond(test::at(law, step.F), at_end, updated), step.F);
      const Mat2 F = step.F + (1e-9 / law.constants.mu) * tau * step.F;
      const Mat4 D = law.respond(test::at(law, F), at_end, updated).tangent;
      if (updated.accumulated == at_end.accumulated) continue;
      const Mat2 to_current = std::is_same_v<Law, FinitePlastic> ? F : Mat2::Identity();
      Mat4 push = Mat4::Zero();
      for (int j = 0; j < 2; ++j)
        for (int J = 0; J < 2; ++J) push.block<2, 2>(2 * j, 2 * J) = to_current(j, J) * Mat2::Identity();
      const Mat4 pushed = push * D * push.transpose();
      ++compared;
      EXPECT_LE((pushed - continuum.moduli).norm(), 1e-5 * law.constants.mu) << name;
    }
  }
  EXPECT_GT(compared, 200);
}
TEST(ContinuumTangent, IsTheLimitOfSmallSteps) {
  expect_continuum_is_the_limit_of_small_steps<SmallPlastic>();
  expect_continuum_is_the_limit_of_small_steps<FinitePlastic>();
}

template <class Law>
void expect_apex_is_known_from_the_state_at_the_end() {
  std::array<int, 2> visits{};
  for (const auto& [name, material] : test::materials()) {
    const Law law{material};
    for (const test::Step& step : test::steps(law, 40)) {
      const Mat2 at = test::at(law, step.F);
      PlasticState end;
      law.respond(at, step.committed, end);
      if (end.accumulated == step.committed.accumulated) continue;
      const bool apex = law.continuum_tangent(at, end).branch == Branch::Apex;
      EXPECT_EQ(law.is_on_apex(at, end), apex) << name;
      ++visits[apex];
    }
  }
  EXPECT_GT(visits[0], 100);
  EXPECT_GT(visits[1], 10);
}
TEST(Apex, IsKnownFromTheStateAtTheEndOfAStep) {
  expect_apex_is_known_from_the_state_at_the_end<SmallPlastic>();
  expect_apex_is_known_from_the_state_at_the_end<FinitePlastic>();
}

template <class Law>
void expect_one_where_elastic_and_zero_on_the_apex() {
  const Law law{{lame(1e10, 0.25), 1.5e8, 0.8, 0.7, 0.0}};
  Mat2 F;
  F << 1.001, 0.002, 0.0, 0.999;
  EXPECT_EQ(localisation(law, test::at(law, F), {}).value, 1.0);
  PlasticState state, unloaded;
  F << 1.01, 0.1, 0.0, 0.99;
  law.respond(test::at(law, F), {}, state);
  EXPECT_LT(localisation(law, test::at(law, F), state).value, 0.9);
  EXPECT_NE(localisation(law, test::at(law, F), state).value, 1.0);
  F(0, 1) -= 0.005;
  law.respond(test::at(law, F), state, unloaded);
  EXPECT_EQ(localisation(law, test::at(law, F), unloaded).value, 1.0);
  F << 1.2, 0.02, 0.01, 1.2;
  law.respond(test::at(law, F), {}, state);
  EXPECT_EQ(law.continuum_tangent(test::at(law, F), state).branch, Branch::Apex);
  EXPECT_EQ(localisation(law, test::at(law, F), state).value, 0.0);
  // exactly on the yield surface, but never yielded
  EXPECT_EQ(branch_of(law, elastic_stress(law.constants, {}), 0.0), Branch::Elastic);
}
TEST(Localisation, IsOneWhereElasticAndZeroOnTheApex) {
  expect_one_where_elastic_and_zero_on_the_apex<SmallPlastic>();
  expect_one_where_elastic_and_zero_on_the_apex<FinitePlastic>();
}

}  // namespace
}  // namespace cleft::constitutive
