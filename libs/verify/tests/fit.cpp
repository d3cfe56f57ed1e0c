#include "cleft/verify/fit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

namespace cleft::verify {
namespace {

std::vector<double> halvings(int count, double coarsest = 0.1) {
  std::vector<double> h;
  for (int k = 0; k < count; ++k) h.push_back(coarsest * std::pow(0.5, k));
  return h;
}

std::vector<double> model(const std::vector<double>& h, double limit, double factor, double order) {
  std::vector<double> q;
  for (const double x : h) q.push_back(limit + factor * std::pow(x, order));
  return q;
}

TEST(FitLimit, RecoversExactSequencesInAnyUnit) {
  for (const double order : {0.5, 1.0, 1.7, 3.0})
    for (const double unit : {1e-9, 1.0, 1e9})
      for (const double size : {1e-3, 1.0, 1e3}) {
        const auto h = halvings(5, size);
        const auto fit = fit_limit(h, model(h, -12.5 * unit, 3.0 * unit * std::pow(size, -order), order));
        EXPECT_NEAR(fit.limit, -12.5 * unit, 1e-6 * unit);
        EXPECT_NEAR(fit.order, order, 1e-6);
        EXPECT_TRUE(fit.determined) << fit.remark;
        EXPECT_LT(fit.scatter, 1e-8 * unit);
      }
}

TEST(FitLimit, ThreeMeshesGiveTheClassicalExtrapolationWithoutUncertainty) {
  const auto h = halvings(3);
  const std::vector<double> q{10.0, 6.0, 4.5};
  const auto fit = fit_limit(h, q);
  EXPECT_NEAR(fit.order, std::log2(4.0 / 1.5), 1e-7);
  EXPECT_NEAR(fit.limit, 4.5 - 1.5 * 1.5 / (4.0 - 1.5), 1e-7);
  EXPECT_TRUE(std::isnan(fit.order_pm) && std::isnan(fit.limit_pm));
  EXPECT_TRUE(fit.determined);
  EXPECT_FALSE(fit.remark.empty());
}

TEST(FitLimit, TakesAKnownLimit) {
  const auto h = halvings(4);
  const auto fit = fit_limit(h, model(h, 7.0, -2.0, 1.5), {.limit = 7.0});
  EXPECT_NEAR(fit.order, 1.5, 1e-10);
  EXPECT_NEAR(fit.factor, -2.0, 1e-9);
  EXPECT_EQ(fit.limit, 7.0);
  EXPECT_EQ(fit.limit_pm, 0.0);
}

// 95 % intervals hold the truth in about 95 of 100 draws; a fair program gets fewer than 90 once in a hundred tries.
TEST(FitLimit, StatesAnUncertaintyThatHoldsInNinetyOfAHundredDraws) {
  for (const double order : {1.0, 2.0})
    for (const int count : {5, 6, 8}) {
      const auto h = halvings(count);
      const double factor = std::pow(0.1, -order);  // the coarsest is off by one
      int order_held = 0, limit_held = 0;
      for (unsigned seed = 0; seed < 100; ++seed) {
        std::mt19937 random(seed);
        std::normal_distribution<double> noise(0.0, 0.003);
        auto q = model(h, 5.0, factor, order);
        for (double& value : q) value += noise(random);
        const auto fit = fit_limit(h, q);
        order_held += std::fabs(fit.order - order) <= fit.order_pm;
        limit_held += std::fabs(fit.limit - 5.0) <= fit.limit_pm;
      }
      EXPECT_GE(order_held, 90) << "order " << order << ", " << count << " meshes";
      EXPECT_GE(limit_held, 90) << "order " << order << ", " << count << " meshes";
    }
}

TEST(FitLimit, TheUncertaintyIsNotWiderThanTheNoiseAsksFor) {
  const auto h = halvings(6);
  auto q = model(h, 5.0, 10.0, 1.0);
  for (std::size_t k = 0; k < q.size(); ++k) q[k] += k % 2 == 0 ? 0.003 : -0.003;
  const auto fit = fit_limit(h, q);
  EXPECT_LT(fit.limit_pm, 0.03);
  EXPECT_LT(fit.order_pm, 0.15);
  EXPECT_TRUE(fit.determined);
}

TEST(FitLimit, SaysWhenTheDataDoNotDetermineTheOrder) {
  const auto h = halvings(5);
  const std::vector<double> noise{1.0, 1.3, 0.9, 1.2, 1.1}, flat(5, 2.0), growing{1.0, 2.0, 4.0, 8.0, 16.0};
  for (const auto* q : {&noise, &flat, &growing}) {
    const auto fit = fit_limit(h, *q);
    EXPECT_FALSE(fit.determined);
    EXPECT_FALSE(fit.remark.empty());
  }
  const auto two = fit_limit(halvings(2), std::vector<double>{1.0, 2.0});
  EXPECT_FALSE(two.determined);
  const auto crossing = fit_limit(h, std::vector<double>{1.0, -0.5, 0.25, 0.1, 0.05}, {.limit = 0.0});
  EXPECT_FALSE(crossing.determined);
  EXPECT_EQ(crossing.remark, "the results cross the limit");
}

TEST(FitLimit, AnOutlierDoesLittleHarm) {
  const auto h = halvings(8);
  auto q = model(h, 5.0, 10.0, 1.0);
  for (std::size_t k = 0; k < q.size(); ++k) q[k] += k % 2 == 0 ? 0.001 : -0.001;
  q[3] += 0.2;  // a plain fit puts the limit off by 0.05
  EXPECT_NEAR(fit_limit(h, q).limit, 5.0, 0.01);
}

TEST(FitLimit, RefusesWhatIsNoSequence) {
  const std::vector<double> one{1.0}, two{1.0, 0.5}, same{0.5, 0.5}, negative{1.0, -0.5}, nan{1.0, std::nan("")};
  EXPECT_THROW(fit_limit(one, one), std::invalid_argument);
  EXPECT_THROW(fit_limit(two, one), std::invalid_argument);
  EXPECT_THROW(fit_limit(same, two), std::invalid_argument);
  EXPECT_THROW(fit_limit(negative, two), std::invalid_argument);
  EXPECT_THROW(fit_limit(two, nan), std::invalid_argument);
}

}  // namespace
}  // namespace cleft::verify
