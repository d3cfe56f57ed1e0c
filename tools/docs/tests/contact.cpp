// A contact that cleft does not have: asperities, which get stiffer as they are pressed together,
//
//     t_N = -p (-g_N / d)^m    where g_N < 0, without friction,
//
// with the pressure p at which they have given way by d. Gap, force and linearisation of the geometry are the
// library's: a law has to say its traction and how that changes with the gap.
#include <gtest/gtest.h>

#include <cmath>

#include "cleft/contact/pair.hpp"

namespace cleft::contact {

struct Asperities {
  double pressure = 0.0;  // p, Pa
  double depth = 0.0;     // d, metres
  double exponent = 2.0;  // m, 1 or greater

  double traction(double gap) const { return gap < 0.0 ? -pressure * std::pow(-gap / depth, exponent) : 0.0; }
  // d t_N / d g_N, Pa/m
  double stiffness(double gap) const {
    return gap < 0.0 ? pressure * exponent / depth * std::pow(-gap / depth, exponent - 1.0) : 0.0;
  }
};

// The force of a pair of points and its exact derivative. `force` takes the traction from the state, and from the law
// in the constants only its stiffness: without an anchor there is no tangential one.
PairForce force(const Asperities& law, const PairPoints& points, PairConstants constants) {
  constants.anchored = false;
  PairState state = evaluate(points, constants);
  constants.law.normal_penalty = law.stiffness(state.normal_gap);
  state.traction = {Status::Stick, law.traction(state.normal_gap), 0.0};
  return force(points, constants, state);
}

namespace {

using Inputs = Eigen::Matrix<double, kPairInputs, 1>;

PairPoints unpack(const Inputs& v) {
  return {v.segment<2>(0), v.segment<2>(2), v.segment<2>(4), v.segment<2>(6), v.segment<2>(8), v.segment<2>(10)};
}

// A lower face that slopes, and an upper one that dips into it.
Inputs example_inputs() {
  Inputs v;
  v << 0.0, 0.0, 1.1, 0.1, -0.4, -0.08, 0.9, 0.02, 0.0, 0.0, 0.0, 0.0;
  return v;
}

PairConstants example_constants() {
  PairConstants c;
  c.weight = 0.7;
  c.eta = 0.3;
  c.share_end = 1.0;
  return c;
}

const Asperities kLaw{.pressure = 3.0, .depth = 0.05};

TEST(ExampleContact, PressesByThePowerOfTheGap) {
  const PairPoints points = unpack(example_inputs());
  const PairConstants c = example_constants();
  const double gap = evaluate(points, c).normal_gap;
  ASSERT_LT(gap, -0.01);
  const auto f = force(kLaw, points, c).force;
  const Vec2 on_own_face = f.segment<2>(0) + f.segment<2>(2), on_partner = f.segment<2>(4) + f.segment<2>(6);
  EXPECT_NEAR(on_own_face.norm(), c.weight * 3.0 * std::pow(gap / 0.05, 2), 1e-12);
  EXPECT_LT((on_own_face + on_partner).norm(), 1e-14);
}

TEST(ExampleContact, TangentIsTheDerivativeOfTheForce) {
  constexpr double kStep = 1e-6;
  const PairForce exact = force(kLaw, unpack(example_inputs()), example_constants());
  for (int k = 0; k < kPairOutputs; ++k) {  // anchor and mouth play no part
    Inputs up = example_inputs(), down = up;
    up[k] += kStep;
    down[k] -= kStep;
    const Eigen::Matrix<double, kPairOutputs, 1> change =
        (force(kLaw, unpack(up), example_constants()).force - force(kLaw, unpack(down), example_constants()).force) /
        (2.0 * kStep);
    EXPECT_LT((change - exact.tangent.col(k)).norm(), 1e-8 * exact.tangent.norm()) << "input " << k;
  }
}

TEST(ExampleContact, LetsGoWhereTheFacesPart) {
  Inputs apart = example_inputs();
  for (const int y : {5, 7}) apart[y] += 0.5;
  const PairForce f = force(kLaw, unpack(apart), example_constants());
  EXPECT_EQ(f.force.norm(), 0.0);
  EXPECT_EQ(f.tangent.norm(), 0.0);
}

}  // namespace
}  // namespace cleft::contact
