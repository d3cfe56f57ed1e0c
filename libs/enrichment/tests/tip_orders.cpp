// Orders of convergence under the exact field of modes I and II, and what the enrichment costs in conditioning.
#include <gtest/gtest.h>

#include "tip_bodies.hpp"

namespace cleft::enrichment {
namespace {

using test::CrackField;
using test::Errors;
using test::Plate;

struct Case {
  Vec2 tip;
  double direction;
};
const std::array<Case, 4> kCases{
    {{{0.0312, 0.0137}, 0.0}, {{0.0312, 0.0137}, 0.4}, {{-0.0213, 0.0}, 0.0}, {{0, 0}, 2.1}}};

CrackField field(const Case& c) { return {c.tip, c.direction, 1.0, 0.7, {}}; }

std::vector<Errors> errors(const Case& c, double radius, std::initializer_list<int> meshes) {
  std::vector<Errors> out;
  for (const int n : meshes) {
    const Plate plate = test::box_with_crack(n, c.tip, c.direction, radius);
    out.push_back(plate.errors(field(c), plate.solve(field(c))));
  }
  return out;
}

TEST(TipOrders, EnergyGoesWithTheFirstAndDisplacementWithTheSecondPower) {
  for (const Case& c : kCases) {
    const auto e = errors(c, 0.5, {10, 20, 40, 80});
    for (std::size_t k = 1; k < e.size(); ++k) {
      EXPECT_NEAR(std::log2(e[k - 1].energy / e[k].energy), 1.0, 0.05) << "direction " << c.direction << ", mesh " << k;
      EXPECT_NEAR(std::log2(e[k - 1].displacement / e[k].displacement), k == 1 ? 1.8 : 1.95, 0.1);
    }
    EXPECT_LT(e.back().energy, 0.018);
  }
}

TEST(TipOrders, EnergyGoesWithTheRootWithoutEnrichment) {
  const auto e = errors({{0.0, 0.0137}, 0.0}, 0.0, {10, 20, 40, 80});  // every mesh has a line through this tip
  for (std::size_t k = 1; k < e.size(); ++k) EXPECT_NEAR(std::log2(e[k - 1].energy / e[k].energy), 0.5, 0.1);
  EXPECT_GT(e.back().energy, 0.1);
}

TEST(TipOrders, AmplitudesApproachTheIntensities) {
  for (const Case& c : kCases) {
    for (const auto& [n, tolerance] : {std::pair{20, 0.025}, std::pair{80, 0.005}}) {
      const CrackField exact = field(c);
      const Plate plate = test::box_with_crack(n, c.tip, c.direction, 0.5);
      const VecX u = plate.solve(exact);
      // F_2 takes (kappa + 1) (K_II, K_I), F_3 (K_I, K_II), over 2 sqrt(2 pi)
      const auto amplitude = [&](int a) -> Vec2 {
        return 2.0 * std::sqrt(2.0 * std::numbers::pi) * exact.turn().transpose() *
               u.segment<2>(2 * plate.unknowns.amplitude(0, a));
      };
      const Vec2 second = amplitude(1) / (exact.elastic.kappa() + 1.0);
      EXPECT_LT((second - Vec2(exact.K_II, exact.K_I)).norm(), tolerance) << n;
      EXPECT_LT((amplitude(2) - Vec2(exact.K_I, exact.K_II)).norm(), 2.0 * tolerance) << n;
    }
  }
}

TEST(TipOrders, QuadratureIsFarBelowTheDiscretisation) {
  for (const Case& c : kCases)
    for (const int n : {10, 20}) {
      const Plate plate = test::box_with_crack(n, c.tip, c.direction, 0.5);
      const Plate fine = test::box_with_crack(n, c.tip, c.direction, 0.5, kPlateau, 2);
      const VecX u = plate.solve(field(c)), better = fine.solve(field(c)), off = u - better;
      const auto K = fine.stiffness();
      const double relative = std::sqrt(off.dot(K * off) / better.dot(K * better));
      EXPECT_LT(relative, 0.03 * fine.errors(field(c), better).energy) << n;
    }
}

// A field without singularity leaves the amplitudes at rest, up to the quadrature of their gradients.
TEST(TipOrders, UniformTensionAlongTheCrackPassesThePatchTest) {
  CrackField tension{{0.0312, 0.0137}, 0.0, 0.0, 0.0, {}};
  tension.uniform << 0.35, 0.0, 0.0, -0.15;
  ASSERT_LT(tension.elastic.stress(tension.uniform).col(1).norm(), 1e-15);
  for (const auto& [n, tolerance] : {std::pair{10, 1e-3}, std::pair{20, 1e-4}, std::pair{40, 5e-6}}) {
    const Plate plate = test::box_with_crack(n, tension.tip, 0.0, 0.5);
    const VecX u = plate.solve(tension);
    EXPECT_LT(plate.errors(tension, u).energy, tolerance) << n;
    EXPECT_LT((u - plate.interpolate(tension)).cwiseAbs().maxCoeff(), tolerance) << n;
  }
}

TEST(TipOrders, ConditionStaysThatOfLinearTriangles) {
  for (const Case& c : kCases)
    for (const int n : {6, 12, 24, 48, 96}) {
      const double h = 2.0 / n;
      EXPECT_LT(test::box_with_crack(n, c.tip, c.direction, 0.5).condition(), 4.0 / (h * h));
    }
}

// Tips anywhere, every other one within a hundredth to a millionth of an element from a node.
TEST(TipOrders, ConditionHardlyDependsOnTheTipsPlace) {
  const int n = 20;
  const double h = 2.0 / n;
  for (int k = 0; k < 24; ++k) {
    const double near = k % 2 == 0 ? 1.0 : std::pow(10.0, -2 - k / 6);
    const Vec2 tip = h * (Vec2(k % 5 - 2, k % 3 - 1) + near * Vec2(0.37 * std::sin(k), 0.41 * std::cos(3 * k)));
    const double direction = k % 3 == 0 ? 0.0 : 0.9 * k;
    const double without = test::box_with_crack(n, tip, direction, 0.0).condition();
    EXPECT_LT(test::box_with_crack(n, tip, direction, 0.3).condition(), 1.4 * without) << k;
  }
}

TEST(TipOrders, QuadratureFollowsBends) {
  for (const test::TipBody& body : test::tip_bodies(11)) {
    Plate fine = body.plate;
    fine.points = make_tip_points(fine.mesh, fine.cut, fine.unknowns, 2);
    const Eigen::MatrixXd coarse = body.plate.stiffness().bottomRightCorner(8, 8),
                          exact = fine.stiffness().bottomRightCorner(8, 8);  // of the amplitudes
    EXPECT_LT((coarse - exact).norm(), 0.005 * exact.norm()) << body.name;
  }
}

// A bend has a weaker singularity of its own. There is no exact solution: the energy is compared with a finer mesh's.
TEST(TipOrders, ABendOutsideOfTheBallDoesNoHarm) {
  const CrackField far{{0.0312, 0.0137}, 0.0, 1.0, 0.3, {}};
  const Vec2 bend(-0.17, 0.0137), tip = bend + 0.2 * Vec2(std::cos(0.35), std::sin(0.35));
  const auto energy = [&](int n, double radius) {
    const Plate plate(geometry::structured_mesh({-1, -1, 1, 1}, {n, n}, geometry::Diagonal::Right),
                      {{"crack", {{-4.0, 0.0137}, bend, tip}, radius}});
    const VecX u = plate.solve(far);
    return u.dot(plate.stiffness() * u);
  };
  const double fine = energy(160, 0.15);
  const auto error = [&](int n, double radius) { return std::sqrt(std::abs(energy(n, radius) - fine) / fine); };
  EXPECT_GT(error(20, 0.15) / error(40, 0.15), 1.8);
  EXPECT_LT(error(40, 0.15), 0.06);
  EXPECT_LT(error(40, 0.5), 0.07) << "nor does it much inside";
  EXPECT_GT(error(40, 0.0), 0.2);
}

TEST(TipOrders, ABallCutByTheBoundaryIsAsGood) {
  const Case near_edge{{0.8, 0.033}, 0.0};
  const auto e = errors(near_edge, 0.5, {20, 40, 80});
  for (std::size_t k = 1; k < e.size(); ++k) EXPECT_NEAR(std::log2(e[k - 1].energy / e[k].energy), 1.0, 0.05);
}

}  // namespace
}  // namespace cleft::enrichment
