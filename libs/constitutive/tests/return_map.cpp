// The return to the cone against the conditions that define it: yield, elastic law and flow rule.
#include <gtest/gtest.h>

#include <array>

#include "plastic_cases.hpp"

namespace cleft::constitutive {
namespace {

using test::between;

// Trial strains up to many times the elastic range, among them hydrostatic and nearly hydrostatic ones and some with
// nearly equal principal values in the plane.
PlaneTensor random_strain(std::mt19937& random) {
  const std::array gaps{1.0, 1.0, 1e-3, 1e-8, 1e-14, 0.0};
  const auto gap = [&] { return gaps[std::uniform_int_distribution<std::size_t>(0, gaps.size() - 1)(random)]; };
  const double size = std::pow(10.0, between(random, -3.0, 0.0));
  const double mean = between(random, -1, 1), in_plane_gap = gap(), out_of_plane_gap = gap();
  return size * PlaneTensor{.centre = mean,
                            .radius = in_plane_gap * Vec2{between(random, -1, 1), between(random, -1, 1)},
                            .normal = mean + out_of_plane_gap * between(random, -1, 1)};
}

DruckerPrager random_material(std::mt19937& random, int kind) {
  const double young = std::pow(10.0, between(random, 0, 10)), poisson = between(random, -0.5, 0.49);
  const Lame c = lame(young, poisson);
  const double hardening = kind % 2 == 0 ? 0.0 : c.mu * between(random, 0.01, 2.0);
  const double strength = c.mu * std::pow(10.0, between(random, -3.0, -0.5));
  if (kind < 2) return von_mises(c, strength, hardening);
  const double friction = between(random, 0.05, 1.4);
  return {c, strength, friction, friction * between(random, 0.1, 1.0), hardening};
}

struct Trial {
  DruckerPrager material;
  PlaneTensor strain;
  double accumulated;
};

std::vector<Trial> trials(int count) {
  std::mt19937 random(11);
  std::vector<Trial> all;
  for (int k = 0; k < count; ++k)
    all.push_back({random_material(random, k % 4), random_strain(random), k % 3 == 0 ? 0.0 : between(random, 0, 0.1)});
  return all;
}

double norm(const PlaneTensor& a) { return std::sqrt(contract(a, a)); }

TEST(ReturnMap, EndsInsideOrOnTheYieldSurface) {
  std::array<int, 3> visits{};
  for (const auto& [m, strain, accumulated] : trials(100000)) {
    const PlasticStep step = plastic_step(m, strain, accumulated);
    ++visits[static_cast<std::size_t>(step.map.branch)];
    const double p = trace(step.stress) / 3.0, shear = norm(deviator(step.stress));
    const double f = yield_function(m, p, shear, accumulated + step.map.multiplier);
    const double trial_size = norm(elastic_stress(m.constants, strain));
    if (step.map.branch == Branch::Elastic) {
      ASSERT_LE(f, 1e-14 * (m.cohesion + trial_size));
    } else {
      ASSERT_LE(std::abs(f), 1e-14 * (m.cohesion + trial_size));
      ASSERT_GT(step.map.multiplier, 0.0);
    }
    if (step.map.branch == Branch::Apex) {
      ASSERT_LE(shear, 1e-15 * trial_size);
    }
  }
  for (const int count : visits) EXPECT_GT(count, 5000);
}

TEST(ReturnMap, ObeysTheElasticLawAndTheFlowRule) {
  for (const auto& [m, strain, accumulated] : trials(100000)) {
    const PlasticStep step = plastic_step(m, strain, accumulated);
    const PlaneTensor& plastic = step.plastic_strain;
    const double size = norm(strain), stress_size = norm(elastic_stress(m.constants, strain));
    const PlaneTensor elastic{strain.centre - plastic.centre, strain.radius - plastic.radius,
                              strain.normal - plastic.normal};
    const PlaneTensor expected = elastic_stress(m.constants, elastic);
    ASSERT_NEAR(step.stress.centre, expected.centre, 1e-13 * stress_size);
    ASSERT_NEAR(step.stress.normal, expected.normal, 1e-13 * stress_size);
    ASSERT_LE((step.stress.radius - expected.radius).norm(), 1e-13 * stress_size);

    const double multiplier = step.map.multiplier;
    ASSERT_NEAR(trace(plastic), m.dilatancy * multiplier, 1e-14 * size);
    const PlaneTensor shape = deviator(plastic), s = deviator(step.stress);
    if (step.map.branch == Branch::Smooth) {
      ASSERT_NEAR(norm(shape), multiplier, 1e-14 * size);
      ASSERT_NEAR(contract(shape, s), multiplier * norm(s), 1e-13 * size * stress_size);  // along s
    } else {
      ASSERT_LE(norm(shape), multiplier * (1 + 1e-14));  // in the cone of normals of the apex
    }
    ASSERT_NEAR(step.work.plastic, contract(step.stress, plastic), 1e-14 * size * stress_size);
    ASSERT_GE(step.work.plastic, -1e-15 * size * stress_size);
  }
}

TEST(ReturnMap, LeavesTheConeByTheViscosityTimesTheRate) {
  std::mt19937 random(5);
  std::array<int, 3> visits{};
  for (auto [m, strain, accumulated] : trials(100000)) {
    m.viscosity = m.constants.mu * std::pow(10.0, between(random, -3, 1));
    const double duration = std::pow(10.0, between(random, -3, 1)), drag = m.viscosity / duration;
    const PlasticStep step = plastic_step(m, strain, accumulated, duration);
    const double gamma = step.map.multiplier, size = m.cohesion + norm(elastic_stress(m.constants, strain));
    const double f = yield_function(m, trace(step.stress) / 3.0, norm(deviator(step.stress)), accumulated + gamma);
    ++visits[static_cast<std::size_t>(step.map.branch)];
    if (step.map.branch == Branch::Elastic) continue;
    ASSERT_NEAR(f, drag * gamma, 1e-14 * size);
    ASSERT_NEAR(step.work.viscous, f * gamma, 1e-14 * size * gamma);
    ASSERT_NEAR(step.work.plastic + step.work.viscous, contract(step.stress, step.plastic_strain),
                1e-14 * size * norm(strain));
  }
  for (const int count : visits) EXPECT_GT(count, 5000);
}

TEST(ReturnMap, ViscousStepWithoutDurationIsElastic) {
  DruckerPrager m{lame(1e4, 0.25), 600.0, 0.8, 0.7, 0.0};
  m.viscosity = 1.0;
  for (const auto& strain : {plane_tensor(0.5, -0.4, 0.2, 0.0), plane_tensor(0.5, 0.5, 0.0, 0.5)}) {
    EXPECT_EQ(plastic_step(m, strain, 0.0).map.branch == Branch::Elastic, false);
    const PlasticStep step = plastic_step(m, strain, 0.0, 0.0);
    EXPECT_EQ(step.map.branch, Branch::Elastic);
    EXPECT_EQ(step.stress.centre, elastic_stress(m.constants, strain).centre);
  }
}

TEST(ReturnMap, IsContinuousFromTheSmoothConeToItsApex) {
  for (const auto& [name, m] : test::materials()) {
    if (m.friction == 0.0) continue;
    const double K = bulk_modulus(m.constants), two_mu = 2.0 * m.constants.mu, accumulated = 0.02;
    const double pressure = 2.0 * m.cohesion / m.friction;
    const double dgamma = yield_function(m, pressure, 0.0, accumulated) / (K * m.friction * m.dilatancy + m.hardening);
    const double edge = two_mu * dgamma;
    const Return smooth = return_to_cone(m, pressure, edge * (1 + 1e-9), accumulated);
    const Return apex = return_to_cone(m, pressure, edge * (1 - 1e-9), accumulated);
    ASSERT_EQ(smooth.branch, Branch::Smooth) << name;
    ASSERT_EQ(apex.branch, Branch::Apex) << name;
    EXPECT_NEAR(smooth.multiplier, apex.multiplier, 1e-8 * dgamma) << name;
    EXPECT_NEAR(smooth.pressure, apex.pressure, 1e-8 * pressure) << name;
    EXPECT_NEAR(smooth.removed, 1.0, 1e-8) << name;
    EXPECT_NEAR(apex.pressure, (m.cohesion + m.hardening * (accumulated + apex.multiplier)) / m.friction,
                1e-13 * pressure)
        << name;
  }
}

// Uniaxial stress by hand, three equal steps: sigma = sigma_y + h (equivalent plastic strain).
TEST(VonMises, HardensByTheUniaxialModulus) {
  const double E = 2.1e5, nu = 0.3, yield = 235.0, h = 1.7e3;
  const DruckerPrager m = von_mises(lame(E, nu), yield, h);
  double accumulated = 0.0, plastic_axial = 0.0;
  for (const double axial : {0.002, 0.005, 0.011}) {
    const double stress = (yield + h * axial) / (1 + h / E), plastic = axial - stress / E;
    // the lateral strain that uniaxial stress has: elastic -nu, plastic -1/2
    const double lateral = -nu * stress / E - 0.5 * plastic;
    const PlaneTensor trial =
        plane_tensor(axial - plastic_axial, lateral + 0.5 * plastic_axial, 0.0, lateral + 0.5 * plastic_axial);
    const PlasticStep step = plastic_step(m, trial, accumulated);
    accumulated += step.map.multiplier;
    plastic_axial += step.plastic_strain.centre + step.plastic_strain.radius[0];
    EXPECT_NEAR(step.stress.centre + step.stress.radius[0], stress, 1e-10);
    EXPECT_NEAR(step.stress.normal, 0.0, 1e-10);
    EXPECT_NEAR(std::sqrt(2.0 / 3.0) * accumulated, plastic, 1e-15);
  }
}

TEST(DruckerPrager, TellsTheBranchOfAStressToNineDigits) {
  const DruckerPrager m{lame(1e10, 0.25), 1.5e9, 0.8, 0.7, 0.0};
  const PlaneTensor on_cone = plastic_step(m, plane_tensor(0.3, -0.2, 0.1, 0.0), 0.0).stress;
  EXPECT_EQ(branch_of(m, on_cone, 1.0), Branch::Smooth);
  EXPECT_EQ(branch_of(m, on_cone, 0.0), Branch::Elastic);  // has not flowed
  EXPECT_EQ(branch_of(m, (1 - 1e-7) * on_cone, 1.0), Branch::Elastic);
  EXPECT_EQ(branch_of(m, (1 - 1e-10) * on_cone, 1.0), Branch::Smooth);
  const PlaneTensor apex = plus_identity({}, m.cohesion / m.friction);
  EXPECT_EQ(branch_of(m, apex, 1.0), Branch::Apex);
  EXPECT_EQ(branch_of(m, (1 - 1e-7) * apex, 1.0), Branch::Elastic);
}

TEST(DruckerPrager, SaysWhetherEveryTrialReturns) {
  const Lame c = lame(1e10, 0.25);
  EXPECT_TRUE(always_returns({c, 1e9, 0.8, 0.7, 0.0}));
  EXPECT_TRUE(always_returns({c, 0.0, 0.8, 0.7, 0.0}));  // sand
  EXPECT_FALSE(always_returns({c, 1e9, 0.8, 0.0, 0.0}));
  EXPECT_FALSE(always_returns({c, 1e9, 0.8, 0.0, 1e7}));
  EXPECT_FALSE(always_returns({c, 1e9, 0.8, 0.7, -1.0}));
  EXPECT_FALSE(always_returns({c, -1.0, 0.8, 0.7, 0.0}));
  EXPECT_FALSE(always_returns({c, 1e9, -0.1, 0.7, 0.0}));
  EXPECT_FALSE(always_returns({c, 1e9, 0.8, -0.7, 0.0}));
  EXPECT_TRUE(always_returns(von_mises(c, 1e9)));
  EXPECT_FALSE(always_returns(von_mises(c, 0.0)));
  EXPECT_FALSE(always_returns({c, std::nan(""), 0.8, 0.7, 0.0}));
}

TEST(DruckerPrager, WithoutCohesionCarriesNoTension) {
  const DruckerPrager sand{lame(1e8, 0.3), 0.0, 0.6, 0.3, 0.0};
  const PlasticStep step = plastic_step(sand, plane_tensor(1e-3, 2e-3, 1e-4, 5e-4), 0.0);
  EXPECT_EQ(step.map.branch, Branch::Apex);
  EXPECT_NEAR(trace(step.stress), 0.0, 1e-9);
  EXPECT_EQ(plastic_step(sand, {}, 0.0).map.branch, Branch::Elastic);
}

}  // namespace
}  // namespace cleft::constitutive
