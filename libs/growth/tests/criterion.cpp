#include "cleft/growth/criterion.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <array>
#include <cmath>
#include <numbers>

#include "bodies.hpp"
#include "cleft/assembly/stress.hpp"
#include "cleft/geometry/advance.hpp"
#include "cleft/problem/tip_reach.hpp"

namespace cleft::growth {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

// The whole body under one deformation gradient, crack closed.
struct Homogeneous {
  assembly::Model model = bodies::edge_crack()();
  VecX displacement;
  std::vector<constitutive::PlasticState> plastic;
  std::vector<contact::Pair> pairs;

  explicit Homogeneous(const Mat2& F) : displacement(model.unknowns.components()) {
    for (Index k = 0; k < model.unknowns.count; ++k)
      displacement.segment<2>(2 * k) = (F - Mat2::Identity()) * model.mesh.nodes[model.unknowns.node_of[k]];
  }
  assembly::Equilibrium equilibrium() const { return {model, 1.0, displacement, plastic, pairs}; }
};

TEST(Rankine, TakesTheLargerPrincipalStressOfAHomogeneousState) {
  Mat2 F;
  F << 1.02, 0.05, -0.01, 0.98;
  const Homogeneous body(F);
  const Mat2 s = assembly::stress_of(body.model.materials.front(), F).in_plane;
  const double expected =
      0.5 * (s(0, 0) + s(1, 1)) + std::sqrt(0.25 * std::pow(s(0, 0) - s(1, 1), 2) + s(0, 1) * s(0, 1));
  const Demand demand = judge(Rankine{2e8, 0.2}, body.equilibrium(), {0, 1});
  EXPECT_NEAR(demand.stress, expected, 1e-9 * expected);
  EXPECT_NEAR(demand.ratio, expected / 2e8, 1e-9);
}

// Under plain strain turned rigidly by an angle the crack takes the same material line: the principal direction turns
// with the body, and pulling it back turns it again.
TEST(Rankine, PullsTheDirectionBack) {
  Mat2 stretch;
  stretch << 1.1, 0.08, 0.08, 0.95;
  const Vec2 still = judge(Rankine{1e8, 0.2}, Homogeneous(stretch).equilibrium(), {0, 1}).ahead;
  for (const double angle : {0.3, -0.7, 1.2}) {
    Mat2 turn;
    turn << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
    const Vec2 turned = judge(Rankine{1e8, 0.2}, Homogeneous(turn * stretch).equilibrium(), {0, 1}).ahead;
    EXPECT_LT((turned - still).norm(), 1e-12) << angle;
  }
}

// The line that is normal to the principal axis n in the current state: material vectors A with n . F A = 0.
TEST(Rankine, LeadsAlongTheMaterialLineThatTheLargestStressOpens) {
  Mat2 F;
  F << 1.3, 0.4, 0.05, 0.9;
  const Homogeneous body(F);
  const Mat2 s = assembly::stress_of(body.model.materials.front(), F).in_plane;
  const double angle = 0.5 * std::atan2(2.0 * s(0, 1), s(0, 0) - s(1, 1));
  const Vec2 n(std::cos(angle), std::sin(angle));
  const Demand demand = judge(Rankine{1e8, 0.2}, body.equilibrium(), {0, 1});
  EXPECT_NEAR(n.dot(F * demand.ahead), 0.0, 1e-12);
  EXPECT_GT(demand.ahead.dot(Vec2(1, 0)), 0.0);
}

// Against a sum over a fine grid of points, each with the stress of the cell that holds it.
TEST(Rankine, IsTheMeanOverTheDisc) {
  auto square = bodies::edge_crack();
  Evolution body = square.stationary(1);
  ASSERT_FALSE(bodies::run(body).failure);
  const auto e = body.stepper().equilibrium();
  const auto& m = e.model;
  const Vec2 tip(0.33, 0.512);
  for (const double radius : {0.12, 0.3}) {
    long inside = 0;
    Mat2 sum = Mat2::Zero();
    const auto count = [&](const std::array<Vec2, 3>& t, const Mat2& stress) {
      const Mat2 sides = (Mat2() << t[1] - t[0], t[2] - t[0]).finished();
      const double spacing = 0.0005;
      Vec2 low = t[0], high = t[0];
      for (const Vec2& x : t) low = low.cwiseMin(x), high = high.cwiseMax(x);
      for (double x = (std::floor(low.x() / spacing) + 0.5) * spacing; x < high.x(); x += spacing)
        for (double y = (std::floor(low.y() / spacing) + 0.5) * spacing; y < high.y(); y += spacing) {
          const Vec2 at(x, y), natural = sides.inverse() * (at - t[0]);
          if ((at - tip).norm() > radius || natural.minCoeff() < 0.0 || natural.sum() > 1.0) continue;
          ++inside;
          sum += stress;
        }
    };
    for (const auto& cell : m.cells) {
      const Mat2 stress = assembly::stress_of(m.materials.front(), cell.deformation(e.displacement)).in_plane;
      const auto& t = m.mesh.triangles[cell.element];
      if (cell.cut == kNone)
        count({m.mesh.nodes[t[0]], m.mesh.nodes[t[1]], m.mesh.nodes[t[2]]}, stress);
      else
        for (const auto& part : m.cut.elements[cell.cut].sub_triangles[static_cast<std::size_t>(cell.side)])
          count(part, stress);
    }
    ASSERT_GT(inside, 1000);
    const Mat2 s = sum / static_cast<double>(inside);
    const double expected = 0.5 * s.trace() + std::hypot(0.5 * (s(0, 0) - s(1, 1)), s(0, 1));
    EXPECT_NEAR(judge(Rankine({1e8, radius}), e, {0, 1}).stress, expected, 5e-4 * expected) << radius;
  }
}

// Elements of 0.1, so triangles of 0.005 m^2: a disc of as much has a radius of 0.0399.
TEST(Rankine, WantsADiscLargerThanAnElement) {
  for (const double ball : {0.0, 0.2}) {
    auto square = bodies::edge_crack();
    square.cracks[0].tip_radius = ball;
    const auto model = square();
    EXPECT_FALSE(problem::spans_elements(model, 0, 1, 0.0398)) << ball;
    EXPECT_TRUE(problem::spans_elements(model, 0, 1, 0.0401)) << ball;
  }
}

// With branch functions the mean is over as much of the solid: of a field that is uniform it is that field, and with
// the tip's own field it depends smoothly on the radius.
TEST(Rankine, IsSmoothInTheRadiusWithinTheBallOfATip) {
  auto square = bodies::edge_crack();
  square.cracks[0].tip_radius = 0.25;
  square.cells = {20, 20};
  Evolution body = square.stationary(1);
  ASSERT_FALSE(bodies::run(body).failure);
  const auto e = body.stepper().equilibrium();
  const auto stress = [&](double radius) { return judge(Rankine({1e8, radius}), e, {0, 1}).stress; };
  for (double r = 0.08; r < 0.22; r += 0.01) {
    const double ratio = stress(r) / stress(r + 0.001);
    EXPECT_GT(ratio, 1.0) << r;
    EXPECT_LT(ratio, 1.0 + 2.0 * 0.5 * 0.001 / r) << r << ": of a mean of 1/r^(1/2) half of dr/r";
  }
}

TEST(HoopStress, IsLargestWhereTheClosedFormsSay) {
  EXPECT_EQ(largest_hoop_stress({3.0, 0.0}).turn, 0.0);
  EXPECT_EQ(largest_hoop_stress({3.0, 0.0}).intensity, 3.0);
  // pure mode II: cos t = 1/3, and K_II (2/3) sqrt(4/3)
  const auto shear = largest_hoop_stress({0.0, 2.0});
  EXPECT_NEAR(shear.turn, -std::acos(1.0 / 3.0), 1e-15);
  EXPECT_NEAR(shear.turn / kDegree, -70.5288, 1e-4);
  EXPECT_NEAR(shear.intensity, 2.0 * std::sqrt(4.0 / 3.0), 1e-14);
  EXPECT_NEAR(largest_hoop_stress({0.0, -2.0}).turn, std::acos(1.0 / 3.0), 1e-15);
  EXPECT_EQ(largest_hoop_stress({-1.0, 2.0}).turn, shear.turn);  // closed faces
}

TEST(HoopStress, IsTheLargestOfAllAngles) {
  for (const double k1 : {0.0, 0.3, 1.0})
    for (const double k2 : {-2.0, -0.4, 0.1, 1.0}) {
      const auto hoop = [&](double t) {
        return std::pow(std::cos(t / 2), 2) * (k1 * std::cos(t / 2) - 3.0 * k2 * std::sin(t / 2));
      };
      double most = -1e9;
      for (int k = -1800; k <= 1800; ++k) most = std::max(most, hoop(k * 0.1 * kDegree));
      const auto found = largest_hoop_stress({k1, k2});
      EXPECT_GE(found.intensity, most - 1e-12);
      EXPECT_NEAR(found.intensity, most, 1e-5);
      EXPECT_NEAR(found.intensity, hoop(found.turn), 1e-12);
    }
}

TEST(HoopStress, OfAnOpenCrackLeadsStraightOn) {
  auto square = bodies::edge_crack();
  square.cracks[0].points = {{0.0, 0.5}, {0.33, 0.5}};  // on the line of symmetry, but for the diagonals
  square.cracks[0].tip_radius = 0.2;
  square.cells = {20, 20};
  square.diagonal = geometry::Diagonal::Alternating;
  Evolution body = square.stationary(1);
  ASSERT_FALSE(bodies::run(body).failure);
  const Demand demand = judge(HoopStress{1e7}, body.stepper().equilibrium(), {0, 1});
  EXPECT_GT(demand.intensities.K_I, 1e7);
  EXPECT_NEAR(demand.ratio, demand.intensities.K_I / 1e7, 0.01 * demand.ratio);
  EXPECT_NEAR(std::atan2(demand.ahead.y(), demand.ahead.x()) / kDegree, 0.0, 3.0);
}

bodies::Square enriched_edge_crack(double length) {
  auto square = bodies::edge_crack();
  square.cracks[0].points[1].x() = length;
  square.cracks[0].tip_radius = 0.2;
  square.cells = {16, 16};
  return square;
}

TEST(HoopStress, HasNoAnswerWithinHalfAnElementOfTheBoundary) {
  for (const double length : {0.95, 0.98}) {  // 0.8 and 0.32 elements away
    Evolution body = enriched_edge_crack(length).stationary(1);
    ASSERT_FALSE(bodies::run(body).failure);
    const Demand demand = judge(HoopStress{1e7}, body.stepper().equilibrium(), {0, 1});
    EXPECT_NEAR(demand.elements, (1.0 - length) * 16.0, 1e-9);
    EXPECT_EQ(std::isnan(demand.ratio), length > 0.96);
    EXPECT_EQ(std::isnan(demand.intensities.K_I), length > 0.96);
    Evolution grows = enriched_edge_crack(length).evolution({.criterion = HoopStress{1e12}, .advance = 0.1}, 1);
    const auto history = bodies::run(grows);
    EXPECT_EQ(history.failure.has_value(), length > 0.96);
    if (history.failure) {
      EXPECT_EQ(std::get<assembly::NoDemand>(history.failure->finding).why, assembly::NoDemand::Why::NoRoom);
    }
  }
}

TEST(HoopStress, AnAdvanceThatWouldLeaveHalfAnElementCutsThrough) {
  for (const auto& [advance, stop] : {std::pair{0.10, Stop::MaxAdvances}, {0.185, Stop::Boundary}}) {
    Evolution body =
        enriched_edge_crack(0.8).evolution({.criterion = HoopStress{1e7}, .advance = advance, .max_advances = 1}, 2);
    const auto history = bodies::run(body);
    ASSERT_FALSE(history.failure) << name_of(history.failure->kind);
    const auto advances = history.advances();
    ASSERT_EQ(advances.size(), 1U);
    EXPECT_EQ(advances[0].stop, stop);
    EXPECT_EQ(advances[0].point.x() == 1.0, stop == Stop::Boundary);
  }
}

}  // namespace
}  // namespace cleft::growth
