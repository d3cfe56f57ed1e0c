// Two plastic points that share their pressure.
#include "cleft/constitutive/patch.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <string>

#include "cleft/constitutive/plastic.hpp"
#include "plastic_cases.hpp"

namespace cleft::constitutive {
namespace {

template <class Law>
class Patch : public testing::Test {};
using PatchLaws = testing::Types<FinitePlastic, SmallPlastic>;
TYPED_TEST_SUITE(Patch, PatchLaws);

struct PatchCase {
  OfPatch<Mat2> F;
  PatchPast past;
};

constexpr double kDuration = 0.5;  // that viscosity notices

std::vector<test::NamedMaterial> materials() {
  auto all = test::materials();
  const Lame c = lame(1.0e4, 0.25);
  all.push_back({"viscous cone", {c, 600.0, 0.8, 0.7, 0.0, 300.0}});
  all.push_back({"viscous hardening cone", {c, 300.0, 0.5, 0.2, 900.0, 200.0}});
  return all;
}

// Pairs of the steps of a single point.
template <class Law>
std::vector<PatchCase> cases(const Law& law) {
  const auto steps = test::steps(law, 11);
  std::vector<PatchCase> out;
  for (const std::size_t apart : {2, 100})  // alike, and any two
    for (std::size_t k = 0; k < steps.size(); ++k) {
      const auto &a = steps[k], &b = steps[(k + apart) % steps.size()];
      out.push_back({{test::at(law, a.F), test::at(law, b.F)}, {{0.3, 0.7}, {a.committed, b.committed}, kDuration}});
    }
  return out;
}

TYPED_TEST(Patch, OfEqualPointsAnswersAsOne) {
  for (const auto& [name, material] : materials()) {
    const TypeParam law{material};
    for (const test::Step& step : test::steps(law, 5)) {
      const Mat2 F = test::at(law, step.F);
      PlasticState updated;
      const Response one = law.respond(F, step.committed, updated, kDuration);
      const PatchPast past{{0.4, 0.6}, {step.committed, step.committed}, kDuration};
      const PatchResponse both = law.respond({F, F}, past);
      const Mat2 by_both = both.pressure_rate[0] + both.pressure_rate[1];
      const double scale = one.tangent.norm() + 1.0;
      for (int i = 0; i < 2; ++i) {
        const Mat4 tangent = both.tangent[i] + Eigen::Map<const Eigen::Vector4d>(both.by_pressure[i].data()) *
                                                   Eigen::Map<const Eigen::Vector4d>(by_both.data()).transpose();
        EXPECT_LE((both.piola[i] - one.piola).norm(), 1e-11 * (one.piola.norm() + 1.0)) << name;
        EXPECT_LE((tangent - one.tangent).norm(), 1e-9 * scale) << name;
        EXPECT_NEAR(both.updated[i].accumulated, updated.accumulated, 1e-12 * (1.0 + updated.accumulated)) << name;
        for (int k = 0; k < 4; ++k) EXPECT_NEAR(both.updated[i].deformation[k], updated.deformation[k], 1e-11) << name;
      }
      const PlasticWork work = law.dissipation(F, step.committed, kDuration), of_both = law.dissipation({F, F}, past);
      EXPECT_NEAR(of_both.plastic, work.plastic, 1e-9 * (1.0 + scale)) << name;
      EXPECT_NEAR(of_both.viscous, work.viscous, 1e-9 * (1.0 + scale)) << name;
    }
  }
}

// Which branches both points are on; on the apex the stress has no deviator.
template <class Law>
std::string branches(const Law& law, const OfPatch<Mat2>& F, const PatchPast& past) {
  const PatchResponse r = law.respond(F, past);
  std::string out;
  for (int i = 0; i < 2; ++i) {
    const bool flows = r.updated[i].accumulated > past.state[i].accumulated;
    const Mat2 stress = test::stress(law, {r.piola[i], {}}, F[i]);
    const double shear = std::hypot(stress(0, 0) - stress(1, 1), 2.0 * stress(0, 1));
    out += !flows ? 'e' : shear < 1e-8 ? 'a' : 's';
  }
  return out;
}

TYPED_TEST(Patch, TangentIsTheDerivativeOfBothStressesInEveryBranch) {
  constexpr double h = 1e-7;
  std::map<std::string, int> visits;
  for (const auto& [name, material] : materials()) {
    const TypeParam law{material};
    const double rounding =
        10.0 * std::numeric_limits<double>::epsilon() * uniaxial_strain_modulus(material.constants) / h;
    for (const auto& [F, past] : cases(law)) {
      const PatchResponse r = law.respond(F, past);
      const std::string on = branches(law, F, past);
      for (int m = 0; m < 2; ++m)
        for (int k = 0; k < 4; ++k) {
          auto up = F, down = F;
          up[m].data()[k] += h;
          down[m].data()[k] -= h;
          if (branches(law, up, past) != on || branches(law, down, past) != on) continue;
          ++visits[on];
          const PatchResponse high = law.respond(up, past), low = law.respond(down, past);
          for (int i = 0; i < 2; ++i) {
            Mat2 exact = r.by_pressure[i] * r.pressure_rate[m].data()[k];
            if (i == m) exact += Eigen::Map<const Mat2>(r.tangent[i].col(k).data());
            EXPECT_LE((exact - (high.piola[i] - low.piola[i]) / (2 * h)).norm(), 1e-6 * r.tangent[i].norm() + rounding)
                << name << ' ' << on << ' ' << i << m << k;
          }
        }
    }
  }
  for (const char* on : {"ee", "ss", "se", "es", "aa", "sa", "as", "ae", "ea"}) EXPECT_GT(visits[on], 50) << on;
}

// Pairs of trial strains, of which the last ones return to the apex of one or both.
std::vector<OfPatch<PlaneTensor>> trials() {
  const PlaneTensor pressed = plane_tensor(0.05, -0.09, 0.02, 0.01), sheared = plane_tensor(0.01, -0.03, 0.3, 0.0),
                    pulled = plane_tensor(0.31, 0.29, 0.02, 0.3), swollen = plane_tensor(0.1, 0.1, 0.0, 0.1);
  return {{pressed, sheared}, {sheared, pressed}, {pressed, pressed}, {sheared, pulled},
          {swollen, sheared}, {pulled, swollen},  {swollen, swollen}};
}

// The yield condition of each point with the common pressure, and one change of volume by flow.
TEST(PatchStep, EndsWithinBothConesAtOnePressure) {
  std::map<Branch, int> visits;
  for (const auto& [name, material] : materials())
    for (const auto& trial : trials()) {
      const PatchPast past{{0.2, 0.8}, {}, kDuration};
      const PatchStep step = patch_step(material, trial, past);
      double mean = 0.0;
      for (int i = 0; i < 2; ++i) mean += past.share[i] * step.multiplier[i];
      for (int i = 0; i < 2; ++i) {
        const PlaneTensor s = deviator(step.stress[i]);
        const double f = yield_function(material, step.pressure, std::sqrt(contract(s, s)), step.multiplier[i]) -
                         drag_of(material, kDuration) * step.multiplier[i];
        EXPECT_LE(f, 1e-9) << name;
        EXPECT_GE(step.multiplier[i], 0.0) << name;
        EXPECT_NEAR(f * step.multiplier[i], 0.0, 1e-9) << name;
        EXPECT_NEAR(trace(step.stress[i]) / 3.0, step.pressure, 1e-9);
        EXPECT_NEAR(trace(step.plastic_strain[i]), material.dilatancy * mean, 1e-14);
        ++visits[step.branch[i]];
      }
      const double elastic = 0.2 * trace(trial[0]) + 0.8 * trace(trial[1]) - material.dilatancy * mean;
      EXPECT_NEAR(step.pressure, bulk_modulus(material.constants) * elastic, 1e-9) << name;
    }
  for (const Branch branch : {Branch::Elastic, Branch::Smooth, Branch::Apex}) EXPECT_GT(visits[branch], 8);
}

// Where the pressure of the apex rounds to its far side as well.
TYPED_TEST(Patch, OnTheApexOfAPerfectConeStaysThereWhenItIsHeld) {
  std::mt19937 random(3);
  const auto pulled = [&](double shape) {
    const double mean = test::between(random, 0.1, 0.3);
    Mat2 F = Mat2(Vec2(1.0 + mean + shape, 1.0 + mean).asDiagonal());
    F(0, 1) = shape * test::between(random, -1.0, 1.0);
    return F;
  };
  for (const auto& [cohesion, friction] : {std::pair{400.0, 0.6}, {100.0, 0.3}, {200.0, 0.3}, {600.0, 0.8}}) {
    const TypeParam law{DruckerPrager{lame(1.0e4, 0.25), cohesion, friction, friction, 0.0}};
    for (int k = 0; k < 200; ++k) {
      const double shape = k % 2 == 0 ? 0.0 : 0.02;
      const OfPatch<Mat2> F{test::at(law, pulled(shape)), test::at(law, pulled(shape))};
      PatchPast past{{0.3, 0.7}, {}};
      const PatchResponse first = law.respond(F, past);
      past.state = first.updated;
      const PatchResponse again = law.respond(F, past);
      for (int i = 0; i < 2; ++i) {
        EXPECT_LE((again.piola[i] - first.piola[i]).norm(), 1e-9 * cohesion) << cohesion << ' ' << friction;
        EXPECT_NEAR(again.updated[i].accumulated, first.updated[i].accumulated, 1e-12);
        EXPECT_LE(again.tangent[i].norm(), 4.0 * uniaxial_strain_modulus(law.constants));  // elastic or of the apex
      }
    }
  }
}

TYPED_TEST(Patch, HasASymmetricTangentWhereFlowIsAssociated) {
  for (const auto& [name, material] : materials()) {
    if (material.friction != material.dilatancy) continue;
    const TypeParam law{material};
    for (const auto& [F, past] : cases(law)) {
      const PatchResponse r = law.respond(F, past);
      const auto row = [](const Mat2& m) { return Eigen::Map<const Eigen::Vector4d>(m.data()); };
      // of the pressure along the rates of one volume only: there the points' own rates of it are the same
      for (int i = 0; i < 2; ++i)
        EXPECT_LE((r.tangent[i] - r.tangent[i].transpose()).norm(), 1e-10 * (r.tangent[i].norm() + 1.0)) << name;
      const Mat4 across = past.share[0] * row(r.by_pressure[0]) * row(r.pressure_rate[1]).transpose();
      const Mat4 back = past.share[1] * row(r.by_pressure[1]) * row(r.pressure_rate[0]).transpose();
      EXPECT_LE((across - back.transpose()).norm(), 1e-10 * (across.norm() + 1.0)) << name;
    }
  }
}

TYPED_TEST(Patch, OfElasticStepsRemembersNothingNew) {
  for (const auto& [name, material] : materials()) {
    const TypeParam law{material};
    Mat2 F = Mat2::Identity();
    F(0, 1) = 1e-4;
    const PatchResponse r = law.respond({test::at(law, F), test::at(law, F)}, {{0.5, 0.5}, {}});
    for (int i = 0; i < 2; ++i) {
      for (const double s : r.updated[i].deformation) EXPECT_EQ(s, 0.0) << name;
      EXPECT_EQ(r.updated[i].accumulated, 0.0);
    }
  }
}

TYPED_TEST(Patch, ThatNothingRelaxesInNoTimeIsElastic) {
  DruckerPrager viscous = test::materials()[0].material;
  viscous.viscosity = 1.0;
  const TypeParam law{viscous};
  const Mat2 F = test::at(law, Mat2(Vec2(1.2, 0.9).asDiagonal()));
  const PatchResponse r = law.respond({F, F}, {{0.5, 0.5}, {}, 0.0});
  EXPECT_EQ(r.updated[0].accumulated, 0.0);
  EXPECT_EQ(law.dissipation({F, F}, {{0.5, 0.5}, {}, 0.0}).viscous, 0.0);
}

}  // namespace
}  // namespace cleft::constitutive
