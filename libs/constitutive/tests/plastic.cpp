// The plastic laws at a point: tangents against differences, objectivity, and limits that have another answer.
#include "cleft/constitutive/plastic.hpp"

#include <gtest/gtest.h>

#include <array>

#include "cleft/constitutive/hencky.hpp"
#include "cleft/constitutive/linear_elastic.hpp"
#include "plastic_cases.hpp"

namespace cleft::constitutive {
namespace {

static_assert(PathDependent<FinitePlastic> && PathDependent<SmallPlastic>);
static_assert(!PathDependent<Hencky> && !PathDependent<LinearElastic>);

template <class Law>
class Plastic : public testing::Test {};
using Laws = testing::Types<FinitePlastic, SmallPlastic>;
TYPED_TEST_SUITE(Plastic, Laws);

TYPED_TEST(Plastic, AtRestIsStressFreeAndLinearElastic) {
  for (const auto& [name, material] : test::materials()) {
    PlasticState updated{{1, 2, 3, 4}, 5};
    const Response r = TypeParam{material}.respond(test::at(TypeParam{material}, Mat2::Identity()), {}, updated);
    const Response linear = LinearElastic{material.constants}.respond(Mat2::Zero());
    EXPECT_EQ(r.piola.norm(), 0.0);
    EXPECT_EQ((r.tangent - linear.tangent).norm(), 0.0);
    for (const double s : updated.deformation) EXPECT_EQ(s, 0.0);
    EXPECT_EQ(updated.accumulated, 0.0);
  }
}

template <class Law>
Mat2 piola(const Law& law, const Mat2& F, const PlasticState& committed) {
  PlasticState updated;
  return law.respond(test::at(law, F), committed, updated).piola;
}

TYPED_TEST(Plastic, TangentIsTheDerivativeOfTheStressInEveryBranch) {
  const double h = 1e-7;  // next to the apex the return bends within |s_tr|/mu
  std::array<int, 3> visits{};
  for (const auto& [name, material] : test::materials()) {
    const TypeParam law{material};
    for (const test::Step& step : test::steps(law, 5)) {
      PlasticState updated;
      const Mat4 D = law.respond(test::at(law, step.F), step.committed, updated).tangent;
      const Branch branch = test::branch_of_step(law, step, step.F);
      for (int k = 0; k < 2; ++k)
        for (int L = 0; L < 2; ++L) {
          Mat2 up = step.F, down = step.F;
          up(k, L) += h;
          down(k, L) -= h;
          if (test::branch_of_step(law, step, up) != branch || test::branch_of_step(law, step, down) != branch)
            continue;
          ++visits[static_cast<std::size_t>(branch)];
          const Mat2 difference = (piola(law, up, step.committed) - piola(law, down, step.committed)) / (2 * h);
          for (int i = 0; i < 2; ++i)
            for (int J = 0; J < 2; ++J)
              ASSERT_NEAR(difference(i, J), D(i + 2 * J, k + 2 * L),
                          1e-6 * D.row(i + 2 * J).cwiseAbs().maxCoeff() + 1e-8 * material.constants.mu)
                  << name << ", branch " << static_cast<int>(branch) << ", F\n"
                  << step.F;
        }
    }
  }
  for (const int count : visits) EXPECT_GT(count, 500);
}

TYPED_TEST(Plastic, ElasticStepLeavesTheStateAsItIs) {
  DruckerPrager strong = test::materials().front().material;
  strong.cohesion = 1e12;
  const PlasticState committed{{0.1, -0.05, 0.02, 0.01}, 0.3};
  PlasticState updated;
  TypeParam{strong}.respond(Mat2(Vec2(0.2, -0.1).asDiagonal()) + test::at(TypeParam{strong}, Mat2::Identity()),
                            committed, updated);
  EXPECT_EQ(updated.deformation, committed.deformation);
  EXPECT_EQ(updated.accumulated, committed.accumulated);
}

// The state at the end of a step, at the same F, is one more step's elastic end: same stress, on the yield surface.
TYPED_TEST(Plastic, StateAtTheEndGivesTheSameStressAgain) {
  for (const auto& [name, material] : test::materials()) {
    const TypeParam law{material};
    for (const test::Step& step : test::steps(law, 6)) {
      PlasticState once, twice;
      const Response first = law.respond(test::at(law, step.F), step.committed, once);
      const Response again = law.respond(test::at(law, step.F), once, twice);
      const double size = law.constants.mu + first.piola.norm();
      ASSERT_LE((first.piola - again.piola).norm(), 1e-13 * size) << name;
      ASSERT_NEAR(twice.accumulated, once.accumulated, 1e-13) << name;
      if (once.accumulated > step.committed.accumulated) {
        EXPECT_NE(law.continuum_tangent(test::at(law, step.F), once).branch, Branch::Elastic) << name;
        EXPECT_GT(law.dissipation(test::at(law, step.F), step.committed).plastic, 0.0) << name;
      } else {
        EXPECT_NEAR(law.dissipation(test::at(law, step.F), step.committed).plastic, 0.0, 1e-16 * law.constants.mu)
            << name;
      }
    }
  }
}

// Over one step viscosity is hardening that starts anew: the same stress and tangent, with another history.
TYPED_TEST(Plastic, ViscosityIsTheHardeningOfOneStep) {
  for (const auto& [name, material] : test::materials()) {
    if (material.hardening > 0.0) continue;
    const double duration = 0.02;
    DruckerPrager viscous = material, hardening = material;
    viscous.viscosity = 30.0;
    hardening.hardening = viscous.viscosity / duration;
    int flows = 0;
    for (const test::Step& step : test::steps(TypeParam{material}, 9)) {
      PlasticState fresh = step.committed, a, b;
      fresh.accumulated = 0.0;
      const Response v = TypeParam{viscous}.respond(test::at(TypeParam{viscous}, step.F), fresh, a, duration);
      const Response h = TypeParam{hardening}.respond(test::at(TypeParam{hardening}, step.F), fresh, b);
      flows += a.accumulated > 0.0;
      EXPECT_LE((v.piola - h.piola).norm(), 1e-14 * h.piola.norm()) << name;
      EXPECT_LE((v.tangent - h.tangent).norm(), 1e-14 * h.tangent.norm()) << name;
      EXPECT_EQ(a.deformation, b.deformation) << name;
      // at the end of the step no time passes, and the stress stays beyond the cone
      PlasticState same;
      EXPECT_LE((TypeParam{viscous}.respond(test::at(TypeParam{viscous}, step.F), a, same, 0.0).piola - v.piola).norm(),
                1e-12 * v.piola.norm());
    }
    EXPECT_GT(flows, 20) << name;
  }
}

// With associated flow a step minimises: stored energy of the elastic strain + (cohesion at its begin) dgamma + H
// dgamma^2/2, whose derivative is the stress. Dissipation is (cohesion at its end) dgamma.
TYPED_TEST(Plastic, AssociatedFlowDerivesFromAPotential) {
  const double h = 1e-6;
  for (const auto& [name, material] : test::materials()) {
    if (material.friction != material.dilatancy) continue;
    const TypeParam law{material};
    for (const test::Step& step : test::steps(law, 7)) {
      const auto potential = [&](const Mat2& F) {
        PlasticState updated;
        law.respond(test::at(law, F), step.committed, updated);
        const double dgamma = updated.accumulated - step.committed.accumulated;
        return law.energy(test::at(law, F), updated) + law.dissipation(test::at(law, F), step.committed).plastic -
               0.5 * law.hardening * dgamma * dgamma;
      };
      PlasticState updated;
      const Response r = law.respond(test::at(law, step.F), step.committed, updated);
      EXPECT_LE((r.tangent - r.tangent.transpose()).norm(), 1e-12 * (r.tangent.norm() + law.constants.mu)) << name;
      for (int i = 0; i < 2; ++i)
        for (int J = 0; J < 2; ++J) {
          Mat2 up = step.F, down = step.F;
          up(i, J) += h;
          down(i, J) -= h;
          if (!test::on_one_branch(law, step, {step.F, up, down})) continue;
          ASSERT_NEAR((potential(up) - potential(down)) / (2 * h), r.piola(i, J), 1e-7 * law.constants.mu) << name;
        }
    }
  }
}

TYPED_TEST(Plastic, OutOfPlaneStressCompletesTheYieldCondition) {
  for (const auto& [name, material] : test::materials()) {
    const TypeParam law{material};
    for (const test::Step& step : test::steps(law, 8)) {
      PlasticState updated;
      const Response r = law.respond(test::at(law, step.F), step.committed, updated);
      if (updated.accumulated == step.committed.accumulated) continue;
      const Mat2 in_plane = test::stress(law, r, step.F);
      const PlaneTensor tau = plane_tensor(in_plane(0, 0), in_plane(1, 1), in_plane(0, 1),
                                           law.out_of_plane_stress(test::at(law, step.F), updated));
      const PlaneTensor s = deviator(tau);
      EXPECT_NEAR(yield_function(law, trace(tau) / 3, std::sqrt(contract(s, s)), updated.accumulated), 0.0,
                  1e-12 * law.constants.mu)
          << name;
    }
  }
}

TEST(FinitePlastic, TurnsWithASuperposedRotation) {
  for (const auto& [name, material] : test::materials()) {
    const FinitePlastic law{material};
    for (const test::Step& step : test::steps(law, 9))
      for (const double angle : {0.3, 1.5707963267948966, 2.9}) {
        const Mat2 R = test::rotation(angle);
        PlasticState still, turned;
        const Mat2 expected = R * law.respond(step.F, step.committed, still).piola;
        const Mat2 found = law.respond(R * step.F, step.committed, turned).piola;
        ASSERT_LE((expected - found).norm(), 2e-14 * (law.constants.mu + expected.norm())) << name;
        for (std::size_t k = 0; k < 4; ++k) ASSERT_NEAR(turned.deformation[k], still.deformation[k], 1e-14) << name;
        ASSERT_NEAR(turned.accumulated, still.accumulated, 1e-14) << name;
      }
  }
}

TEST(FinitePlastic, IsHenckyWhereElastic) {
  const Lame c = lame(1.0e4, 0.25);
  const FinitePlastic law{{c, 1e9, 0.3, 0.1, 0.0}};
  const Hencky hencky{c};
  for (const test::Step& step : test::steps(law, 10)) {
    PlasticState updated;
    const Response found = law.respond(step.F, {}, updated), expected = hencky.respond(step.F);
    EXPECT_LE((found.piola - expected.piola).norm(), 1e-14 * c.mu + 1e-14 * expected.piola.norm());
    EXPECT_LE((found.tangent - expected.tangent).norm(), 5e-15 * expected.tangent.norm());
    EXPECT_NEAR(law.energy(step.F, {}), hencky.energy(step.F), 1e-14 * c.mu);
  }
}

// On a plastic deformation that leaves the thickness alone, the law is Hencky's in the elastic part F F^p^-1.
TEST(FinitePlastic, IsHenckyInTheElasticPartOfF) {
  const Lame c = lame(1.0e4, 0.4);
  const FinitePlastic law{{c, 1e9, 0.3, 0.1, 0.0}};
  std::mt19937 random(3);
  for (int k = 0; k < 200; ++k) {
    const Mat2 elastic = test::stretched(random, test::between(random, -0.3, 0.3), 0.4);
    const Mat2 plastic = test::stretched(random, test::between(random, -0.3, 0.3), 0.6);
    Mat2 inverse;
    inverse << plastic(1, 1), -plastic(0, 1), -plastic(1, 0), plastic(0, 0);
    inverse /= det(plastic);
    const Mat2 metric = inverse * inverse.transpose() - Mat2::Identity();
    const PlasticState state{{metric(0, 0), metric(1, 1), metric(0, 1), 0.0}, 1.0};
    const Mat2 F = elastic * plastic;
    PlasticState updated;
    const Mat2 found = law.respond(F, state, updated).piola * F.transpose();
    const Mat2 expected = Hencky{c}.respond(elastic).piola * elastic.transpose();
    EXPECT_LE((found - expected).norm(), 1e-13 * c.lambda);
    EXPECT_NEAR(law.energy(F, state), Hencky{c}.energy(elastic), 1e-13 * c.lambda);
  }
}

TEST(FinitePlastic, TendsToSmallStrain) {
  for (const double size : {1e-6, 1e-9, 1e-12})
    for (auto [name, material] : test::materials()) {
      material.cohesion = 0.5 * size * material.constants.mu;
      std::mt19937 random(4);
      PlasticState finite_state, small_state;
      for (int k = 0; k < 20; ++k) {
        const auto component = [&] {
          return std::ldexp(std::round(std::ldexp(test::between(random, -size, size), 52)), -52);
        };
        Mat2 F = Mat2::Identity();  // steps of a power of two, so that F - I is exact
        for (int i = 0; i < 4; ++i) F(i) += component();
        const PlasticState before_finite = finite_state, before_small = small_state;
        const Response finite = FinitePlastic{material}.respond(F, before_finite, finite_state);
        const Response small =
            SmallPlastic{material}.respond(test::at(SmallPlastic{material}, F), before_small, small_state);
        const double floor = 20 * size;  // the kinematics differ by the square of the strain
        ASSERT_LE((finite.piola - small.piola).norm(), floor * size * material.constants.mu * 10 + 1e-15 * size)
            << name;
        for (std::size_t c = 0; c < 3; ++c)
          ASSERT_NEAR(finite_state.deformation[c], -2.0 * small_state.deformation[c], 100 * size * size + 1e-14 * size)
              << name;
      }
    }
}

TEST(FinitePlastic, J2FlowKeepsTheVolumeOverManySteps) {
  const FinitePlastic law{von_mises(lame(2.1e5, 0.3), 235.0, 1000.0)};
  PlasticState state;
  for (int k = 1; k <= 2000; ++k) {
    Mat2 F;
    F << 1.0 + 0.1 * std::sin(0.02 * k), 0.002 * k, 0.0, 1.0 - 0.1 * std::sin(0.01 * k);
    PlasticState updated;
    law.respond(F, state, updated);
    state = updated;
  }
  const auto& c = state.deformation;
  const double volume = ((1 + c[0]) * (1 + c[1]) - c[2] * c[2]) * (1 + c[3]);
  EXPECT_NEAR(volume, 1.0, 1e-12);
  EXPECT_GT(state.accumulated, 2.0);
}

TEST(SmallPlastic, TangentHasBothMinorSymmetries) {
  for (const auto& [name, material] : test::materials()) {
    const SmallPlastic law{material};
    for (const test::Step& step : test::steps(law, 12)) {
      PlasticState updated;
      const Mat4 D = law.respond(test::at(law, step.F), step.committed, updated).tangent;
      EXPECT_EQ((D.row(1) - D.row(2)).norm(), 0.0);
      EXPECT_EQ((D.col(1) - D.col(2)).norm(), 0.0);
    }
  }
}

TEST(LinearElastic, IsTheTangentOfHenckyAtRest) {
  const LinearElastic law{lame(3.0e9, 0.31)};
  const Mat4 hencky = Hencky{law.constants}.respond(Mat2::Identity()).tangent;
  Mat2 H;
  H << 0.3, 0.2, -0.5, -0.2;
  const Response r = law.respond(H);
  EXPECT_LE((r.tangent - hencky).norm(), 1e-15 * hencky.norm());
  const Eigen::Vector4d strain(0.3, -0.15, -0.15, -0.2), sigma = r.tangent * strain;
  EXPECT_NEAR(r.piola(0, 0), sigma[0], 1e-6);
  EXPECT_NEAR(r.piola(1, 0), sigma[1], 1e-6);
  EXPECT_NEAR(r.piola(0, 1), sigma[2], 1e-6);
  EXPECT_NEAR(r.piola(1, 1), sigma[3], 1e-6);
  EXPECT_NEAR(law.energy(H), 0.5 * strain.dot(sigma), 1e-6);
  EXPECT_EQ(law.respond(Mat2::Zero()).piola.norm(), 0.0);
}

TEST(LinearElastic, KeepsTheDigitsOfStrainsFarBelowOne) {
  const LinearElastic law{lame(2.0e18, 0.3)};
  Mat2 H;
  H << 1.1e-14, 0.7e-14, -0.3e-14, -2.3e-14;
  const Mat2 small = law.respond(H).piola, large = law.respond(1e12 * H).piola;
  EXPECT_LE((1e12 * small - large).norm(), 1e-15 * large.norm());
}

}  // namespace
}  // namespace cleft::constitutive
