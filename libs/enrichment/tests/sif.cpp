#include "cleft/enrichment/sif.hpp"

#include <gtest/gtest.h>

#include "plate.hpp"

namespace cleft::enrichment {
namespace {

using test::CrackField;
using test::Plate;

const PlaneStrain kBody{1.0, 0.3};  // that of test::Elastic

TEST(UnitField, IsTheOneInTheBooks) {
  for (const Mode mode : {Mode::I, Mode::II}) {
    const CrackField book{{0, 0}, 0.0, mode == Mode::I ? 1.0 : 0.0, mode == Mode::I ? 0.0 : 1.0, {}};
    for (const double r : {0.01, 0.7})
      for (const double t : {-3.1, -1.0, 0.0, 0.6, 2.0, 3.1}) {
        const ModeField field = unit_field(mode, r, t, kBody);
        const Vec2 X = r * Vec2(std::cos(t), std::sin(t));
        EXPECT_LT((field.displacement - book.displacement(X, {})).norm(), 1e-14);
        EXPECT_LT((field.gradient - book.gradient(X, {})).norm(), 1e-13);
        EXPECT_LT((field.stress - book.elastic.stress(book.gradient(X, {}))).norm(), 1e-13);
      }
  }
}

TEST(UnitField, GradientIsTheDerivativeAndStressInEquilibrium) {
  constexpr double kStep = 1e-5;
  for (const Mode mode : {Mode::I, Mode::II})
    for (const double t : {-2.9, -0.4, 1.3, 2.5}) {
      const Vec2 X = 0.5 * Vec2(std::cos(t), std::sin(t));
      const auto at = [&](const Vec2& x) { return unit_field(mode, x.norm(), std::atan2(x.y(), x.x()), kBody); };
      Vec2 divergence = Vec2::Zero();
      for (const int j : {0, 1}) {
        const Vec2 step = kStep * Vec2::Unit(j);
        const ModeField plus = at(X + step), minus = at(X - step);
        EXPECT_LT(((plus.displacement - minus.displacement) / (2 * kStep) - at(X).gradient.col(j)).norm(), 1e-9);
        divergence += (plus.stress - minus.stress).col(j) / (2 * kStep);
      }
      EXPECT_LT(divergence.norm(), 1e-8);
    }
}

TEST(UnitField, LeavesTheFacesFree) {
  for (const Mode mode : {Mode::I, Mode::II})
    for (const double t : {-std::numbers::pi, std::numbers::pi})
      EXPECT_LT(unit_field(mode, 0.2, t, kBody).stress.col(1).norm(), 1e-15);
}

TEST(UnitField, StressAheadDefinesTheIntensity) {
  const double r = 0.3, unit = 1.0 / std::sqrt(2.0 * std::numbers::pi * r);
  EXPECT_NEAR(unit_field(Mode::I, r, 0.0, kBody).stress(1, 1), unit, 1e-14);
  EXPECT_NEAR(unit_field(Mode::II, r, 0.0, kBody).stress(0, 1), unit, 1e-14);
}

std::vector<FacePiece> pieces_of_faces(const Plate& plate, const Mat2& stress) {
  std::vector<FacePiece> out;
  for (const Face& face : make_faces(plate.mesh, plate.cut, plate.unknowns)) {
    const Vec2 along = (face.reference_end - face.reference_start).normalized();
    const Vec2 outward = face.normal_sign() * turn_left(along);
    out.push_back({face.reference_start, face.reference_end, face.side, stress * outward});
  }
  return out;
}

Intensities found(const Plate& plate, const VecX& u, const std::vector<FacePiece>& faces) {
  const auto state = [&](const TipPoint& point) {
    const Mat2 H = point.deformation(u) - Mat2::Identity();
    return PointState{H, kBody.stress(H)};
  };
  return interaction_integral(plate.cut.tips[0], 0, plate.points, state, {faces}, kBody);
}

TEST(InteractionIntegral, FindsTheIntensitiesOfTheExactField) {
  for (const double direction : {0.0, 0.4, -2.0}) {
    const CrackField exact{{0.0312, 0.0137}, direction, 1.3, -0.7, {}};
    const Plate plate = test::box_with_crack(40, exact.tip, direction, 0.5);
    const auto state = [&](const TipPoint& p) {
      const Mat2 H = exact.gradient(p.reference, p.side);
      return PointState{H, kBody.stress(H)};
    };
    const auto K = interaction_integral(plate.cut.tips[0], 0, plate.points, state, {}, kBody);
    EXPECT_NEAR(K.K_I, 1.3, 5e-5);
    EXPECT_NEAR(K.K_II, -0.7, 5e-5);
  }
}

TEST(InteractionIntegral, IsOfSecondOrderInAComputedField) {
  for (const double direction : {0.0, 0.4}) {
    const CrackField exact{{0.0312, 0.0137}, direction, 1.0, 0.7, {}};
    for (const auto& [n, tolerance] : {std::pair{20, 0.003}, std::pair{40, 0.001}, std::pair{80, 0.0004}}) {
      const Plate plate = test::box_with_crack(n, exact.tip, direction, 0.5);
      const auto K = found(plate, plate.solve(exact), {});
      EXPECT_NEAR(K.K_I, 1.0, tolerance) << n;
      EXPECT_NEAR(K.K_II, 0.7, tolerance) << n;
    }
  }
}

// The ball sticks out of the body ahead of the tip, at a corner, beside the crack; and holds half of its mouth.
TEST(InteractionIntegral, GoesNoFartherThanTheBodyIsWhole) {
  for (const auto& [tip, direction] : {std::pair{Vec2(0.783, 0.0137), 0.0},
                                       {Vec2(0.76, 0.743), 0.4},
                                       {Vec2(0.0312, -0.79), 0.0},
                                       {Vec2(-0.77, 0.0137), 0.0}}) {
    const CrackField exact{tip, direction, 1.0, 0.7, {}};
    const Plate plate = test::box_with_crack(40, exact.tip, direction, 0.5);
    ASSERT_LT(plate.cut.tips[0].reach, 0.26);
    const auto K = found(plate, plate.solve(exact), {});
    EXPECT_NEAR(K.K_I, 1.0, 0.003) << tip.transpose();
    EXPECT_NEAR(K.K_II, 0.7, 0.003) << tip.transpose();
  }
}

// Both functions and unknowns of the ball stay; only the integral becomes narrow. tools/docs/pages/tips.md has the
// table.
TEST(InteractionIntegral, IsWithinOnePercentDownToHalfAnElement) {
  const CrackField exact{{0.0312, 0.0137}, 0.4, 1.0, 0.7, {}};
  Plate plate = test::box_with_crack(40, exact.tip, 0.4, 0.25);  // 5 h
  const VecX u = plate.solve(exact);
  for (const double elements : {3.0, 2.0, 1.0, 0.5}) {
    plate.cut.tips[0].reach = elements / 20.0;
    const auto K = found(plate, u, {});
    EXPECT_NEAR(K.K_I, 1.0, 0.01) << elements;
    EXPECT_NEAR(K.K_II, 0.7, 0.01) << elements;
  }
}

// A body that hangs by its weight, with a crack along the stress: it does not notice.
TEST(InteractionIntegral, ABodyForceCounts) {
  constexpr double kWeight = 3.0, kAlong = 0.35, kAcross = -0.15;  // strains over the stress: (1 - nu)/2, -nu/2
  const Plate plate = test::box_with_crack(20, {0.0312, 0.0137}, 0.5 * std::numbers::pi, 0.5);
  const auto state = [&](const TipPoint& p) {
    const double s = kWeight * p.reference.y(), shear = kAcross * kWeight * p.reference.x();
    Mat2 H;
    H << kAcross * s, shear, -shear, kAlong * s;
    return PointState{H, kBody.stress(H)};
  };
  const auto hanging = [&](const Vec2& force) {
    return interaction_integral(plate.cut.tips[0], 0, plate.points, state, {{}, force}, kBody);
  };
  EXPECT_NEAR(hanging({0.0, -kWeight}).K_I, 0.0, 1e-4);
  EXPECT_NEAR(hanging({0.0, -kWeight}).K_II, 0.0, 1e-4);
  EXPECT_GT(std::abs(hanging({0.0, 0.0}).K_I), 0.05) << "it does matter";
}

// A closed crack under pressure whose faces slide: mode II, and a uniform stress that the faces transmit.
struct Closed {
  CrackField exact{{0.0312, 0.0137}, 0.0, 0.0, 0.5, {}};
  Mat2 stress;
  Closed() {
    stress << -0.4, 0.3, 0.3, -1.0;
    exact.uniform = 0.5 * (stress - 0.3 * stress.trace() * Mat2::Identity());
  }
};

TEST(InteractionIntegral, ClosedFrictionalFacesCountWithTheirTraction) {
  const Closed closed;
  const Plate plate = test::box_with_crack(40, closed.exact.tip, 0.0, 0.5);
  const auto state = [&](const TipPoint& p) {
    const Mat2 H = closed.exact.gradient(p.reference, p.side);
    return PointState{H, kBody.stress(H)};
  };
  const auto faces = pieces_of_faces(plate, closed.stress);
  const auto K = interaction_integral(plate.cut.tips[0], 0, plate.points, state, {faces}, kBody);
  EXPECT_NEAR(K.K_I, 0.0, 0.001);
  EXPECT_NEAR(K.K_II, 0.5, 0.001);
  const auto without = interaction_integral(plate.cut.tips[0], 0, plate.points, state, {}, kBody);
  EXPECT_GT(std::abs(without.K_II - 0.5), 0.05) << "it does matter";
}

TEST(InteractionIntegral, FindsModeTwoOfAComputedClosedCrack) {
  const Closed closed;
  const Plate plate = test::box_with_crack(40, closed.exact.tip, 0.0, 0.5);  // h = R / 10
  VecX force = VecX::Zero(plate.unknowns.components());
  for (const Face& face : make_faces(plate.mesh, plate.cut, plate.unknowns)) {
    const Vec2 along = face.reference_end - face.reference_start;
    const Vec2 half = 0.5 * face.normal_sign() * closed.stress * turn_left(along);
    for (const Stencil* end : {&face.start, &face.end})
      for (std::size_t k = 0; k < end->unknown.size(); ++k)
        force.segment<2>(2 * end->unknown[k]) += end->weight[k] * half;
  }
  const auto K = found(plate, plate.solve(closed.exact, force), pieces_of_faces(plate, closed.stress));
  EXPECT_NEAR(K.K_I, 0.0, 0.001);
  EXPECT_NEAR(K.K_II, 0.5, 0.001);
}

TEST(Amplitudes, SayTheIntensitiesOfTheirOwnField) {
  const Plate plate = test::box_with_crack(10, {0.03, 0.01}, 0.4, 0.5);
  const CrackField exact{{0.03, 0.01}, 0.4, 1.3, -0.7, {}};
  std::array<Vec2, kBranches> c;
  for (int a = 0; a < kBranches; ++a)
    c[a] = exact.turn() * (1.3 * unit_amplitudes(Mode::I, kBody)[a] - 0.7 * unit_amplitudes(Mode::II, kBody)[a]);
  const auto K = intensities_of_amplitudes(plate.cut.tips[0], c, kBody);
  EXPECT_NEAR(K.K_I, 1.3, 1e-14);
  EXPECT_NEAR(K.K_II, -0.7, 1e-14);
}

}  // namespace
}  // namespace cleft::enrichment
