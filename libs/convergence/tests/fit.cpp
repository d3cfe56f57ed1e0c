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
        const auto h = halvings(6, size);
        const auto fit = fit_limit(h, model(h, -12.5 * unit, 3.0 * unit * std::pow(size, -order), order));
        EXPECT_NEAR(fit.limit, -12.5 * unit, 1e-6 * unit);
        EXPECT_NEAR(fit.order, order, 1e-6);
        EXPECT_NEAR(fit.factor, 3.0 * unit * std::pow(size, -order), 1e-5 * fit.factor);
        EXPECT_NEAR(fit.asymptotic_ratio, 1.0, 1e-6);
        EXPECT_TRUE(fit.determined) << fit.remark;
        EXPECT_LT(fit.scatter, 1e-8 * unit);
        EXPECT_EQ(fit.window, 6u);
        EXPECT_EQ(fit.kind, SeriesClass::Monotone);
      }
}

TEST(FitLimit, TellsTheObservedOrderOfEachThreeMeshes) {
  const std::vector<double> h{0.4, 0.2, 0.1, 0.05}, q{14.0, 10.0, 6.0, 4.5};
  const auto fit = fit_limit(h, q);
  ASSERT_EQ(fit.observed_order.size(), 2u);
  EXPECT_NEAR(fit.observed_order[0], 0.0, 1e-7);
  EXPECT_NEAR(fit.observed_order[1], std::log2(4.0 / 1.5), 1e-9);
  const auto uneven = fit_limit(std::vector{0.3, 0.2, 0.05}, model({0.3, 0.2, 0.05}, 1.0, 2.0, 1.3));
  EXPECT_NEAR(uneven.observed_order.at(0), 1.3, 1e-9);
}

TEST(FitLimit, ThreeMeshesGiveAnIndexWithTheFactorOfThreeAndDetermineNothing) {
  const auto h = halvings(3);
  for (const double order : {0.5, 1.0, 2.0}) {
    const auto fit = fit_limit(h, model(h, 5.0, std::pow(0.1, -order), order));
    EXPECT_FALSE(fit.determined);
    EXPECT_EQ(fit.safety, 3.0);
    EXPECT_GT(fit.finest_pm, 3.0 * std::pow(0.25, order)) << "three times the error";
    EXPECT_NE(fit.remark.find("3 meshes do not determine"), std::string::npos) << fit.remark;
  }
}

TEST(FitLimit, TakesAKnownLimit) {
  const auto h = halvings(4);
  const auto fit = fit_limit(h, model(h, 7.0, -2.0, 1.5), {.limit = 7.0});
  EXPECT_NEAR(fit.order, 1.5, 1e-6);
  EXPECT_NEAR(fit.factor, -2.0, 1e-5);
  EXPECT_EQ(fit.limit, 7.0);
  EXPECT_EQ(fit.limit_pm, 0.0);
  EXPECT_TRUE(fit.determined) << fit.remark;
  EXPECT_TRUE(std::isnan(fit.finest_pm)) << "the error is known";
  ASSERT_EQ(fit.observed_order.size(), 3u);
  EXPECT_NEAR(fit.observed_order[0], 1.5, 1e-9);
  EXPECT_FALSE(fit_limit(halvings(3), model(halvings(3), 7.0, -2.0, 1.5), {.limit = 7.0}).determined);
}

// What is coarser than the finest four meshes does not tell how they behave: with a known limit as without.
TEST(FitLimit, TheFinestFourMeshesTellTheClass) {
  const auto h = halvings(6);
  auto q = model(h, 7.0, -2.0, 1.5);
  q[0] = 7.1;
  q[1] = 7.05;
  EXPECT_STREQ(name_of(fit_limit(h, q, {.limit = 7.0}).kind), "monotone");
  q[2] = 7.01;
  EXPECT_STREQ(name_of(fit_limit(h, q, {.limit = 7.0}).kind), "oscillating");
}

// Distances from the finest solution vanish there and not at h = 0: a fit of C h^p finds too high an order.
TEST(FitLimit, TakesDistancesFromAMeshOfTheSequence) {
  for (const double order : {0.8, 1.5, 3.0}) {
    const auto h = halvings(5);
    std::vector<double> distance;
    for (int k = 0; k < 4; ++k) distance.push_back(2.0 * (std::pow(h[k], order) - std::pow(h[4], order)));
    const std::span<const double> coarser(h.data(), 4);
    const auto fit = fit_limit(coarser, distance, {.limit = 0.0, .reference_h = h[4]});
    EXPECT_NEAR(fit.order, order, 1e-6);
    EXPECT_NEAR(fit.factor, 2.0, 1e-5);
    EXPECT_LT(fit.scatter, 1e-8);
    EXPECT_NEAR(fit.observed_order.back(), order, 1e-9);
    EXPECT_GT(fit_limit(coarser, distance, {.limit = 0.0}).order, order + 0.05);
    EXPECT_THROW(fit_limit(h, h, {.limit = 0.0, .reference_h = h[4]}), std::invalid_argument);
  }
}

// Q0 + C x^p (1 + a x + b x^2): more coarse meshes must not make the answer worse.
TEST(FitLimit, PreAsymptoticMeshesAreNotTakenForNoise) {
  for (const double a : {-0.3, 0.3})
    for (const double b : {-0.3, 0.0, 0.3}) {
      const auto h = halvings(8, 1.0);
      std::vector<double> q;
      for (const double x : h) q.push_back(5.0 + x * x * (1.0 + a * x + b * x * x));
      for (const std::size_t coarsest : {0, 2}) {
        const auto fit = fit_limit(std::span(h).subspan(coarsest), std::span(q).subspan(coarsest));
        EXPECT_TRUE(fit.determined) << fit.remark;
        EXPECT_LE(std::fabs(fit.order - 2.0), fit.order_pm);
        EXPECT_LE(std::fabs(fit.limit - 5.0), fit.limit_pm);
        EXPECT_LT(std::fabs(fit.limit - 5.0), 0.1 * std::fabs(q.back() - 5.0));
        EXPECT_LE(std::fabs(q.back() - 5.0), fit.finest_pm);
        EXPECT_LE(fit.finest_pm, 2.0 * std::fabs(q.back() - 5.0)) << "nor must it be exaggerated";
        EXPECT_NEAR(fit.asymptotic_ratio, 1.0, 0.05);
      }
    }
}

// The coarsest mesh does not see what the others converge to.
TEST(FitLimit, LeavesOutCoarseMeshesThatContradictTheFineOnes) {
  const auto h = halvings(7);
  auto q = model(h, 5.0, 10.0, 1.0);
  q[0] += 30.0;
  const auto fit = fit_limit(h, q);
  EXPECT_TRUE(fit.determined) << fit.remark;
  EXPECT_NEAR(fit.order, 1.0, 0.01);
  EXPECT_NEAR(fit.limit, 5.0, 0.001);
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
  EXPECT_NEAR(other.finest_pm, 1e6 * fit.finest_pm, 1.0);
  EXPECT_NEAR(other.scatter, 1e6 * fit.scatter, 1.0);
  EXPECT_LT(fit.scatter, 0.01) << "a root mean square";
  EXPECT_NEAR(other.order, fit.order, 1e-5);
  EXPECT_NEAR(other.order_pm, fit.order_pm, 1e-5);
}

struct Unclear {
  const char* name;
  std::vector<double> value;
  const char* remark;
  SeriesClass kind;
  FitOptions options = {};
};
class Undetermined : public testing::TestWithParam<Unclear> {};

TEST_P(Undetermined, IsSaidWithTheReason) {
  const auto& [name, value, remark, kind, options] = GetParam();
  const auto fit = fit_limit(halvings(static_cast<int>(value.size())), value, options);
  EXPECT_FALSE(fit.determined);
  EXPECT_NE(fit.remark.find(remark), std::string::npos) << fit.remark;
  EXPECT_STREQ(name_of(fit.kind), name_of(kind));
}

INSTANTIATE_TEST_SUITE_P(
    FitLimit, Undetermined,
    testing::Values(
        Unclear{"two_meshes", {1.0, 2.0}, "2 meshes show nothing", SeriesClass::TooFew},
        Unclear{"noise", {1.0, 1.3, 0.9, 1.2, 1.1}, "the order may be below", SeriesClass::Oscillating},
        Unclear{"flat", {2.0, 2.0, 2.0, 2.0, 2.0}, "equal but for rounding", SeriesClass::Exact},
        Unclear{"rounding", {2.0, 2.0, 2.0 + 1e-14, 2.0, 2.0 - 2e-15}, "equal but for rounding", SeriesClass::Exact},
        Unclear{"growing", {1.0, 2.0, 4.0, 8.0, 16.0}, "do not get smaller", SeriesClass::Diverging},
        Unclear{"steep", model(halvings(5), 1.0, 1e8, 8.0), "the order may be above 5", SeriesClass::Monotone},
        Unclear{"scattered", {2.0, 1.4, 1.35, 1.05, 1.2}, "the order may be below", SeriesClass::Oscillating},
        Unclear{"logarithmic", {8.0, 7.0, 6.0, 5.0, 4.0}, "do not get smaller", SeriesClass::Diverging},
        Unclear{"large", {-1.9e9, -1.85e9, -1.83e9, -1.9e9}, "the order may be below", SeriesClass::Oscillating},
        Unclear{"crossing", {1.0, -0.5, 0.25, 0.1, 0.05}, "cross the limit", SeriesClass::Oscillating, {.limit = 0.0}},
        Unclear{"all_exact", {7.0, 7.0, 7.0}, "the results are exact", SeriesClass::Exact, {.limit = 7.0}},
        Unclear{"one_error", {7.0, 7.0, 8.0}, "one error above", SeriesClass::TooFew, {.limit = 7.0}}),
    [](const auto& u) { return std::string(u.param.name); });

TEST(FitLimit, OfEqualResultsIsTheirValue) {
  const auto fit = fit_limit(halvings(4), std::vector{3.0, 2.0, 2.0 + 1e-14, 2.0});
  EXPECT_EQ(fit.kind, SeriesClass::Exact);
  EXPECT_EQ(fit.limit, 2.0);
  EXPECT_LT(fit.finest_pm, 1e-9);
  EXPECT_TRUE(std::isnan(fit.order));
}

// Few meshes and one that is off: the index covers the error wherever that mesh is.
TEST(FitLimit, AnOutlierOfFiveOrSixMeshesDoesNotDeceive) {
  for (const int count : {5, 6}) {
    const auto h = halvings(count, 1.0);
    for (int place = 0; place < count; ++place)
      for (const double off : {-0.2, 0.2}) {
        auto q = model(h, 5.0, 1.0, 2.0);
        q[static_cast<std::size_t>(place)] += off;
        const auto fit = fit_limit(h, q);
        EXPECT_LE(std::fabs(q.back() - 5.0), fit.finest_pm) << place << " of " << count;
        if (fit.determined) {
          EXPECT_LE(std::fabs(fit.limit - 5.0), fit.limit_pm) << place << " of " << count;
          EXPECT_LE(std::fabs(fit.order - 2.0), fit.order_pm) << place << " of " << count;
        }
      }
  }
}

TEST(FitLimit, AnOutlierDoesLittleHarm) {
  const auto h = halvings(8);
  for (const std::size_t place : {4, 5, 6, 7}) {
    auto q = model(h, 5.0, 100.0, 2.0);
    for (std::size_t k = 0; k < q.size(); ++k) q[k] += k % 2 == 0 ? 0.001 : -0.001;
    q[place] += 0.2;  // least squares put the limit off by 0.03 to 0.04
    const auto fit = fit_limit(h, q);
    EXPECT_NEAR(fit.limit, 5.0, 0.005) << "at mesh " << place;
    EXPECT_LE(std::fabs(q.back() - 5.0), fit.finest_pm) << "at mesh " << place;
  }
}

// What a user of thirty meshes has: the finest twelve tell enough.
TEST(FitLimit, TakesManyMeshesInAnyOrder) {
  std::vector<double> h;
  for (int k = 0; k < 30; ++k) h.push_back(std::pow(1.1, k % 2 == 0 ? k : -k));
  const auto fit = fit_limit(h, model(h, 5.0, 1.0, 2.0));
  EXPECT_NEAR(fit.limit, 5.0, 1e-6);
  EXPECT_LE(fit.window, 12u);
}

TEST(FitLimit, RefusesWhatIsNoSequence) {
  const std::vector<double> one{1.0}, two{1.0, 0.5}, same{0.5, 0.5}, negative{1.0, -0.5}, nan{1.0, std::nan("")},
      endless{INFINITY, 1.0}, huge{1.7e308, -1.7e308};
  EXPECT_THROW(fit_limit(one, one), std::invalid_argument);
  EXPECT_THROW(fit_limit(two, one), std::invalid_argument);
  EXPECT_THROW(fit_limit(same, two), std::invalid_argument);
  EXPECT_THROW(fit_limit(negative, two), std::invalid_argument);
  EXPECT_THROW(fit_limit(endless, two), std::invalid_argument);
  EXPECT_THROW(fit_limit(two, nan), std::invalid_argument);
  EXPECT_THROW(fit_limit(two, huge), std::invalid_argument);
}

TEST(FitPower, RecoversExactLaws) {
  const std::vector<double> x{1e3, 4e3, 1.7e4, 6.6e4};
  for (const double exponent : {-1.0, 0.0, 1.0, 1.4}) {
    const auto fit = fit_power(x, model(x, 0.0, 3e-5, exponent));
    EXPECT_NEAR(fit.order, exponent, 1e-8);
    EXPECT_NEAR(fit.factor, 3e-5, 1e-11);
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
  const std::vector<double> sizes{1e3, 2e3, 4e3, 8e3}, scattered{1.0, 3.0, 3.5, 9.0}, clean{1.0, 2.0, 4.0, 8.0};
  const auto loose = fit_power(sizes, scattered);
  EXPECT_FALSE(loose.determined) << loose.order_pm;
  EXPECT_EQ(loose.remark, "these meshes do not determine the exponent");
  EXPECT_TRUE(fit_power(sizes, clean).determined);
  EXPECT_NEAR(fit_power(sizes, clean).order, 1.0, 1e-6);
}

TEST(FitPower, ThreeCostsDetermineNothing) {
  const std::vector<double> sizes{1e3, 2e3, 4e3}, clean{1.0, 2.0, 4.0};
  const auto fit = fit_power(sizes, clean);
  EXPECT_FALSE(fit.determined);
  EXPECT_NEAR(fit.order, 1.0, 1e-6);
  EXPECT_EQ(fit.remark, "three meshes do not determine an exponent");
}

TEST(FitPower, OneCostThatIsOffWidensTheInterval) {
  const std::vector<double> sizes{1e3, 2e3, 4e3, 8e3, 16e3};
  std::vector<double> cost = model(sizes, 0.0, 1e-5, 1.3);
  cost[4] *= 2.0;
  const auto fit = fit_power(sizes, cost);
  EXPECT_GE(fit.order_pm, std::fabs(fit.order - 1.3));
  EXPECT_FALSE(fit.determined);
}

}  // namespace
}  // namespace cleft::convergence
