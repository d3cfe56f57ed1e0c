// The mean of plastic histories.
#include <gtest/gtest.h>

#include "plastic_cases.hpp"

namespace cleft::constitutive {
namespace {

double plastic_volume(const PlasticState& state) {
  const auto& [xx, yy, xy, zz] = state.deformation;
  return ((1.0 + xx) * (1.0 + yy) - xy * xy) * (1.0 + zz);
}

// C^p^-1 - 1 of principal values, the first of them at an angle to the x axis.
PlasticState of_principal(double first, double second, double third, double angle) {
  const Mat2 R = test::rotation(angle), plane = R * Vec2(first, second).asDiagonal() * R.transpose();
  return {{plane(0, 0) - 1.0, plane(1, 1) - 1.0, plane(0, 1), third - 1.0}, 0.0};
}

void expect_near(const PlasticState& a, const PlasticState& b, double tolerance) {
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(a.deformation[k], b.deformation[k], tolerance);
  EXPECT_NEAR(a.accumulated, b.accumulated, tolerance);
}

TEST(PlasticMean, OfEqualHistoriesIsThatHistoryToTheLastBit) {
  const PlasticState state{{0.1, -0.07, 0.033, 0.01}, 0.7};
  const std::vector<WeightedState> states{{0.1, state}, {0.3, state}, {1e-17, state}};
  EXPECT_EQ(SmallPlastic::mean(states), state);
  EXPECT_EQ(FinitePlastic::mean(states), state);
}

TEST(PlasticMean, OfNoneIsAtRest) {
  EXPECT_EQ(SmallPlastic::mean({}), PlasticState{});
  EXPECT_EQ(FinitePlastic::mean({}), PlasticState{});
}

TEST(PlasticMean, OfSmallStrainIsThatOfThePlasticStrain) {
  const std::vector<WeightedState> states{{1.0, {{0.1, 0.2, -0.3, 0.4}, 1.0}}, {3.0, {{0.5, 0.2, 0.1, -0.4}, 3.0}}};
  expect_near(SmallPlastic::mean(states), {{0.4, 0.2, 0.0, -0.2}, 2.5}, 1e-15);
}

TEST(PlasticMean, OfCoaxialDeformationsIsTheirGeometricMean) {
  for (const double angle : {0.0, 0.3, 1.5, -2.0}) {
    const std::vector<WeightedState> states{{1.0, of_principal(4.0, 0.25, 1.0, angle)},
                                            {2.0, of_principal(0.5, 0.5, 4.0, angle)}};
    expect_near(FinitePlastic::mean(states),
                of_principal(std::cbrt(4.0 * 0.25), std::cbrt(0.25 * 0.25), std::cbrt(16.0), angle), 1e-14);
  }
}

TEST(PlasticMean, HasTheGeometricMeanOfVolumes) {
  std::mt19937 random(3);
  for (int k = 0; k < 50; ++k) {
    std::vector<WeightedState> states;
    double sum = 0.0, logarithm = 0.0;
    for (int n = 0; n < 4; ++n) {
      const auto stretch = [&] { return std::exp(test::between(random, -1.0, 1.0)); };
      states.push_back({test::between(random, 0.1, 1.0),
                        of_principal(stretch(), stretch(), stretch(), test::between(random, -3.0, 3.0))});
      sum += states.back().weight;
      logarithm += states.back().weight * std::log(plastic_volume(states.back().state));
    }
    EXPECT_NEAR(std::log(plastic_volume(FinitePlastic::mean(states))), logarithm / sum, 1e-13);
  }
}

TEST(PlasticMean, TurnsWithTheBodyAtRest) {
  const auto mean = [](double turn) {
    const std::vector<WeightedState> states{{1.0, of_principal(3.0, 0.5, 0.9, 0.2 + turn)},
                                            {1.5, of_principal(0.4, 2.0, 1.2, 1.0 + turn)}};
    return FinitePlastic::mean(states);
  };
  const PlasticState still = mean(0.0), turned = mean(0.7);
  Mat2 C;
  C << still.deformation[0], still.deformation[2], still.deformation[2], still.deformation[1];
  const Mat2 expected = test::rotation(0.7) * C * test::rotation(0.7).transpose();
  expect_near(turned, {{expected(0, 0), expected(1, 1), expected(0, 1), still.deformation[3]}, 0.0}, 1e-14);
}

// Small plastic strains keep their digits, and both kinematics agree: C^p^-1 - 1 is minus twice the plastic strain.
TEST(PlasticMean, OfSmallDeformationsIsThatOfThePlasticStrain) {
  const std::vector<WeightedState> states{{1.0, {{1e-12, 2e-12, -3e-12, 4e-12}, 1e-12}},
                                          {3.0, {{5e-12, 2e-12, 1e-12, -4e-12}, 3e-12}}};
  expect_near(FinitePlastic::mean(states), SmallPlastic::mean(states), 1e-22);
}

}  // namespace
}  // namespace cleft::constitutive
