#include "cleft/convergence/fit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

namespace cleft::convergence {
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

// Distances from the finest solution vanish there and not at h = 0: a fit of C h^p finds too high an order.
TEST(FitLimit, TakesDistancesFromAMeshOfTheSequence) {
  for (const double order : {0.8, 1.5, 3.0}) {
    const auto h = halvings(4);
    std::vector<double> distance;
    for (int k = 0; k < 3; ++k) distance.push_back(2.0 * (std::pow(h[k], order) - std::pow(h[3], order)));
    const std::span<const double> coarser(h.data(), 3);
    const auto fit = fit_limit(coarser, distance, {.limit = 0.0, .reference_h = h[3]});
    EXPECT_NEAR(fit.order, order, 1e-6);
    EXPECT_NEAR(fit.factor, 2.0, 1e-5);
    EXPECT_LT(fit.scatter, 1e-8);
    EXPECT_GT(fit_limit(coarser, distance, {.limit = 0.0}).order, order + 0.05);
    EXPECT_THROW(fit_limit(h, h, {.limit = 0.0, .reference_h = h[3]}), std::invalid_argument);
  }
}

// 95 % intervals hold the truth in about 95 of 100 draws; a fair program gets fewer than 90 once in a hundred tries.
class Coverage : public testing::TestWithParam<std::tuple<double, int, double>> {};

TEST_P(Coverage, HoldsInNinetyOfAHundredDraws) {
  const auto& [order, count, deviation] = GetParam();
  const auto h = halvings(count);
  const double factor = std::pow(0.1, -order);  // the coarsest is off by one
  int order_held = 0, limit_held = 0;
  for (unsigned seed = 0; seed < 100; ++seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0.0, deviation);
    auto q = model(h, 5.0, factor, order);
    for (double& value : q) value += noise(random);
    const auto fit = fit_limit(h, q);
    order_held += std::fabs(fit.order - order) <= fit.order_pm;
    limit_held += std::fabs(fit.limit - 5.0) <= fit.limit_pm;
  }
  EXPECT_GE(order_held, 90);
  EXPECT_GE(limit_held, 90);
}

INSTANTIATE_TEST_SUITE_P(FitLimit, Coverage,
                         testing::Combine(testing::Values(0.5, 1.0, 2.0, 3.0), testing::Values(4, 5, 6, 8),
                                          testing::Values(0.003, 0.03)));

TEST(FitLimit, TheUncertaintyIsNotWiderThanTheNoiseAsksFor) {
  const auto h = halvings(6);
  auto q = model(h, 5.0, 10.0, 1.0);
  for (std::size_t k = 0; k < q.size(); ++k) q[k] += k % 2 == 0 ? 0.003 : -0.003;
  const auto fit = fit_limit(h, q);
  EXPECT_LT(fit.limit_pm, 0.03);
  EXPECT_LT(fit.order_pm, 0.15);
  EXPECT_TRUE(fit.determined);
}

TEST(FitLimit, UncertaintiesTurnWithTheUnit) {
  const auto h = halvings(6);
  auto q = model(h, 5.0, 10.0, 1.0);
  for (std::size_t k = 0; k < q.size(); ++k) q[k] += k % 2 == 0 ? 0.003 : -0.003;
  const auto fit = fit_limit(h, q);
  for (double& value : q) value = 3.0 - 1e6 * value;
  const auto other = fit_limit(h, q);
  EXPECT_NEAR(other.limit, 3.0 - 1e6 * fit.limit, 1.0);
  EXPECT_NEAR(other.limit_pm, 1e6 * fit.limit_pm, 1.0);
  EXPECT_NEAR(other.scatter, 1e6 * fit.scatter, 1.0);
  EXPECT_NEAR(fit.scatter, 0.003, 0.001) << "a root mean square";
  EXPECT_NEAR(other.order, fit.order, 1e-5);
  EXPECT_NEAR(other.order_pm, fit.order_pm, 1e-5);
}

struct Unclear {
  const char* name;
  std::vector<double> value;
  const char* remark;
  FitOptions options = {};
};
class Undetermined : public testing::TestWithParam<Unclear> {};

TEST_P(Undetermined, IsSaidWithTheReason) {
  const auto& [name, value, remark, options] = GetParam();
  const auto fit = fit_limit(halvings(static_cast<int>(value.size())), value, options);
  EXPECT_FALSE(fit.determined);
  EXPECT_NE(fit.remark.find(remark), std::string::npos) << fit.remark;
  EXPECT_EQ(std::isnan(fit.order), value.size() < 3 || value.front() == value.back());
}

INSTANTIATE_TEST_SUITE_P(
    FitLimit, Undetermined,
    testing::Values(Unclear{"two_meshes", {1.0, 2.0}, "need three meshes"},
                    Unclear{"noise", {1.0, 1.3, 0.9, 1.2, 1.1}, "the order"},
                    Unclear{"flat", {2.0, 2.0, 2.0, 2.0, 2.0}, "all results are equal"},
                    Unclear{"growing", {1.0, 2.0, 4.0, 8.0, 16.0}, "runs into its bound 0.1"},
                    Unclear{"steep", model(halvings(5), 1.0, 1e8, 8.0), "runs into its bound 6"},
                    Unclear{"scattered", {2.0, 1.4, 1.35, 1.05, 1.2}, "the order is uncertain by"},
                    Unclear{"crossing", {1.0, -0.5, 0.25, 0.1, 0.05}, "the results cross the limit", {.limit = 0.0}},
                    Unclear{"all_exact", {7.0, 7.0, 7.0}, "the results are exact", {.limit = 7.0}}),
    [](const auto& u) { return std::string(u.param.name); });

// Two minima each: a solution that starts from the wrong end of the orders stays in the worse one.
TEST(FitLimit, StartsFromSeveralOrders) {
  const auto h = halvings(4);
  EXPECT_NEAR(fit_limit(h, std::vector<double>{1.5, 0.1, 1.2, 1.5}).order, 6.0, 1e-6);
  EXPECT_NEAR(fit_limit(h, std::vector<double>{1.0, 1.4, 1.9, 0.3}).order, 0.1, 1e-6);
}

TEST(FitLimit, AnOutlierDoesLittleHarm) {
  const auto h = halvings(8);
  for (const std::size_t place : {3, 4, 5, 6, 7}) {
    auto q = model(h, 5.0, 100.0, 2.0);
    for (std::size_t k = 0; k < q.size(); ++k) q[k] += k % 2 == 0 ? 0.001 : -0.001;
    q[place] += 0.2;  // least squares put the limit off by 0.03 to 0.04
    const auto fit = fit_limit(h, q);
    EXPECT_NEAR(fit.limit, 5.0, 0.005) << "at mesh " << place;
    EXPECT_NEAR(fit.order, 2.0, 0.05) << "at mesh " << place;
  }
}

TEST(FitLimit, RefusesWhatIsNoSequence) {
  const std::vector<double> one{1.0}, two{1.0, 0.5}, same{0.5, 0.5}, negative{1.0, -0.5}, nan{1.0, std::nan("")},
      endless{INFINITY, 1.0};
  EXPECT_THROW(fit_limit(one, one), std::invalid_argument);
  EXPECT_THROW(fit_limit(two, one), std::invalid_argument);
  EXPECT_THROW(fit_limit(same, two), std::invalid_argument);
  EXPECT_THROW(fit_limit(negative, two), std::invalid_argument);
  EXPECT_THROW(fit_limit(endless, two), std::invalid_argument);
  EXPECT_THROW(fit_limit(two, nan), std::invalid_argument);
}

TEST(FitPower, RecoversExactLaws) {
  const std::vector<double> x{1e3, 4e3, 1.7e4, 6.6e4};
  for (const double exponent : {-1.0, 0.0, 1.0, 1.4}) {
    const auto fit = fit_power(x, model(x, 0.0, 3e-5, exponent));
    EXPECT_NEAR(fit.order, exponent, 1e-8);
    EXPECT_NEAR(fit.factor, 3e-5, 1e-11);
    EXPECT_EQ(fit.limit, 0.0);
    EXPECT_LT(fit.order_pm, 1e-6);
    EXPECT_TRUE(fit.determined) << fit.remark;
  }
}

TEST(FitPower, RecoversNoisyOnesWithinTheirUncertainty) {
  for (const std::size_t count : {4U, 7U}) {
    std::vector<double> x;
    for (std::size_t k = 0; k < count; ++k) x.push_back(1e4 * std::pow(2.0, static_cast<double>(k)));
    int held = 0;
    double widest = 0.0;
    for (unsigned seed = 0; seed < 100; ++seed) {
      std::mt19937 random(seed);
      std::normal_distribution<double> noise(0.0, 0.05);
      auto seconds = model(x, 0.0, 2e-7, 1.3);
      for (double& value : seconds) value *= std::exp(noise(random));
      const auto fit = fit_power(x, seconds);
      held += std::fabs(fit.order - 1.3) <= fit.order_pm;
      widest = std::fmax(widest, fit.order_pm);
    }
    EXPECT_GE(held, 90) << count << " points";
    EXPECT_LE(widest, 0.4) << count << " points";
  }
}

TEST(FitPower, LeavesOutWhatTookNothing) {
  const std::vector<double> x{1.0, 2.0, 4.0, 8.0}, cost{0.0, 4.0, 16.0, 64.0};
  EXPECT_NEAR(fit_power(x, cost).order, 2.0, 1e-8);
}

TEST(FitPower, SaysWhereThereAreTooFew) {
  const std::vector<double> x{1.0, 2.0, 4.0}, same{2.0, 2.0, 2.0}, rising{1.0, 2.0, 4.0}, nothing{0.0, 0.0, 0.0};
  const std::pair<std::vector<double>, std::vector<double>> faults[] = {
      {{}, {}}, {{1.0, 2.0}, {1.0, 2.0}}, {x, nothing}, {x, {0.0, 1.0, 2.0}}, {same, rising}};
  for (const auto& [at, cost] : faults) {
    const auto fit = fit_power(at, cost);
    EXPECT_FALSE(fit.determined);
    EXPECT_TRUE(std::isnan(fit.order) && std::isnan(fit.order_pm));
    EXPECT_NE(fit.remark.find("needs three"), std::string::npos) << fit.remark;
  }
  EXPECT_THROW(fit_power(x, std::vector<double>{1.0}), std::invalid_argument);
  EXPECT_THROW(fit_power(x, std::vector<double>{1.0, 2.0, std::nan("")}), std::invalid_argument);
  EXPECT_THROW(fit_power(std::vector<double>{0.0, 1.0, 2.0}, rising), std::invalid_argument);
}

TEST(FitPower, OfCostsThatScatterDoesNotClaimAnExponent) {
  const std::vector<double> sizes{1e3, 2e3, 4e3}, scattered{1.0, 9.0, 2.0}, clean{1.0, 2.0, 4.0};
  const auto loose = fit_power(sizes, scattered);
  EXPECT_FALSE(loose.determined);
  EXPECT_EQ(loose.remark, "these meshes do not determine the exponent");
  EXPECT_TRUE(fit_power(sizes, clean).determined);
  EXPECT_NEAR(fit_power(sizes, clean).order, 1.0, 1e-6);
}

}  // namespace
}  // namespace cleft::convergence
