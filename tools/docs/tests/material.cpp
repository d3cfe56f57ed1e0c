// A material that cleft does not have: Ciarlet's and Geymonat's. Its energy per unit reference volume,
//
//     W = mu/2 (tr b - 3) - mu ln J + lambda/4 (J^2 - 1 - 2 ln J),
//
// grows without bound both where the volume vanishes and where it grows.
#include <gtest/gtest.h>

#include <cmath>

#include "cleft/constitutive/elastic.hpp"
#include "cleft/constitutive/kinematics.hpp"
#include "cleft/constitutive/response.hpp"

namespace cleft::constitutive {

struct CiarletGeymonat {
  Lame constants;

  double energy(const Mat2& deformation) const {
    const double J = det(deformation), log_j = std::log(J);
    return 0.5 * constants.mu * (deformation.squaredNorm() - 2.0) - constants.mu * log_j +
           0.25 * constants.lambda * (J * J - 1.0 - 2.0 * log_j);
  }

  // P = mu F + p F^-T with p = lambda/2 (J^2 - 1) - mu, and F^-T = cof F / J.
  Response respond(const Mat2& deformation) const {
    const Eigen::Vector4d F = Eigen::Map<const Eigen::Vector4d>(deformation.data());
    const double J = det(deformation), p = 0.5 * constants.lambda * (J * J - 1.0) - constants.mu;
    const Eigen::Vector4d G = cofactor_map() * F / J;  // F^-T, and dJ/dF = J F^-T
    Response out;
    Eigen::Map<Eigen::Vector4d>(out.piola.data()) = constants.mu * F + p * G;
    out.tangent =
        constants.mu * Mat4::Identity() + p / J * cofactor_map() + (constants.lambda * J * J - p) * G * G.transpose();
    return out;
  }
};

// What the assembly asks of a law: it takes the branch of finite strain without memory.
static_assert(!PathDependent<CiarletGeymonat> && !kIsSmallStrain<CiarletGeymonat>);

namespace {

const CiarletGeymonat kLaw{lame(2.5, 0.3)};

double energy_at(const Mat2& F) { return kLaw.energy(F); }
Mat2 stress_at(const Mat2& F) { return kLaw.respond(F).piola; }

std::vector<Mat2> deformations() {
  std::vector<Mat2> all;
  for (const double angle : {0.0, 0.4, 2.0})
    for (const double stretch : {0.5, 1.0, 1.8}) {
      Mat2 turn, shape;
      turn << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
      shape << stretch, 0.3, 0.0, 1.1;
      all.push_back(turn * shape);
    }
  return all;
}

// The derivative of a function of F with regard to one component, by a central difference.
template <class Value>
Value difference(Value (*function)(const Mat2&), const Mat2& F, int i, int J) {
  constexpr double kStep = 1e-5;
  Mat2 up = F, down = F;
  up(i, J) += kStep;
  down(i, J) -= kStep;
  return (function(up) - function(down)) / (2.0 * kStep);
}

TEST(ExampleMaterial, IsAtRestAndLinearElasticUndeformed) {
  const Response r = kLaw.respond(Mat2::Identity());
  EXPECT_EQ(r.piola.norm(), 0.0);
  Mat2 strain;
  strain << 0.3, 0.1, 0.1, -0.2;
  const Eigen::Vector4d rate = r.tangent * Eigen::Map<const Eigen::Vector4d>(strain.data());
  const Mat2 exact = kLaw.constants.lambda * strain.trace() * Mat2::Identity() + 2.0 * kLaw.constants.mu * strain;
  EXPECT_LT((rate - Eigen::Map<const Eigen::Vector4d>(exact.data())).norm(), 1e-14);
}

TEST(ExampleMaterial, StressIsTheDerivativeOfTheEnergy) {
  for (const Mat2& F : deformations())
    for (int i = 0; i < 2; ++i)
      for (int J = 0; J < 2; ++J) EXPECT_NEAR(difference(energy_at, F, i, J), stress_at(F)(i, J), 1e-8);
}

TEST(ExampleMaterial, TangentIsTheDerivativeOfTheStress) {
  for (const Mat2& F : deformations())
    for (int k = 0; k < 2; ++k)
      for (int L = 0; L < 2; ++L) {
        const Mat2 column = difference(stress_at, F, k, L);
        EXPECT_LT((Eigen::Map<const Eigen::Vector4d>(column.data()) - kLaw.respond(F).tangent.col(k + 2 * L)).norm(),
                  1e-8);
      }
}

}  // namespace
}  // namespace cleft::constitutive
