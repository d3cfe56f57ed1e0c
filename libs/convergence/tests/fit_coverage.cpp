// How often the intervals of a fit hold: sequences Q0 + C x^p (1 + a x + b x^2), x = h / h_max, with random a and b,
// random scatter and one random outlier. A few draws of some cells by default; with CLEFT_COVERAGE_DRAWS=N in the
// environment N draws of all cells, and the rows of the table on the documentation's page fits.md.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <vector>

#include "cleft/convergence/fit.hpp"

namespace cleft::convergence {
namespace {

constexpr double kLimit = 5.0;
constexpr double kOutlier = 0.2;  // as scatter over C, the coarsest mesh's error in the asymptotic range

struct Cell {
  int meshes;
  double order, ratio, scatter, pre_asymptotic;
  bool outlier;
};

struct Drawn {
  std::vector<double> h, value;
};

Drawn draw(const Cell& cell, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> within(-cell.pre_asymptotic, cell.pre_asymptotic);
  std::normal_distribution<double> normal(0.0, 1.0);
  const double a = within(random), b = within(random);
  Drawn out;
  for (int k = 0; k < cell.meshes; ++k) {
    const double x = std::pow(cell.ratio, -k);
    out.h.push_back(0.1 * x);
    out.value.push_back(kLimit + std::pow(x, cell.order) * (1.0 + a * x + b * x * x) + cell.scatter * normal(random));
  }
  const std::size_t place = random() % out.value.size();
  const double sign = random() % 2 == 0 ? 1.0 : -1.0;
  if (cell.outlier) out.value[place] += sign * kOutlier;
  return out;
}

struct Count {
  int draws = 0, finest = 0;                 // finest result covered
  int determined = 0, order = 0, limit = 0;  // of those: order covered, limit nearer than the finest result
  std::vector<double> exaggeration;          // uncertainty over error of the finest result

  double covered() const { return static_cast<double>(finest) / draws; }
  // what a share of 0.9 may look like in so few draws: three standard deviations less
  static double least(double share, int draws) { return share - 3.0 * std::sqrt(share * (1.0 - share) / draws); }
};

Count count(const Cell& cell, int draws) {
  Count out;
  for (int k = 0; k < draws; ++k) {
    const Drawn drawn = draw(cell, static_cast<unsigned>(k));
    const LimitFit fit = fit_limit(drawn.h, drawn.value);
    const double error = std::fabs(drawn.value.back() - kLimit);
    ++out.draws;
    out.finest += error <= fit.finest_pm;
    out.exaggeration.push_back(fit.finest_pm / error);
    if (!fit.determined) continue;
    ++out.determined;
    out.order += std::fabs(fit.order - cell.order) <= fit.order_pm;
    out.limit += std::fabs(fit.limit - kLimit) < error;
  }
  std::sort(out.exaggeration.begin(), out.exaggeration.end());
  return out;
}

void expect_covers(const Cell& cell, const Count& c) {
  EXPECT_GE(c.covered(), Count::least(0.9, c.draws))
      << fmt::format("{} meshes, order {}, ratio {}, scatter {}, A = {}, {} outlier", cell.meshes, cell.order,
                     cell.ratio, cell.scatter, cell.pre_asymptotic, cell.outlier ? "one" : "no");
}

// Cells of a row of the table: all orders and ratios.
struct Row {
  double least_covered = 1.0;
  int draws = 0, finest = 0, determined = 0, order = 0, limit = 0;
  std::vector<double> exaggeration;

  void add(const Count& c) {
    least_covered = std::fmin(least_covered, c.covered());
    draws += c.draws;
    finest += c.finest;
    determined += c.determined;
    order += c.order;
    limit += c.limit;
    exaggeration.push_back(c.exaggeration[c.exaggeration.size() / 2]);
  }

  void add(const Row& row) {
    draws += row.draws;
    finest += row.finest;
    determined += row.determined;
    order += row.order;
    limit += row.limit;
  }

  void print(const Cell& cell) {
    std::sort(exaggeration.begin(), exaggeration.end());
    const bool any = determined > 0;
    fmt::print("| {} | {} | {} | {} | {:.0f} | {:.0f} | {:.1f} | {:.1f} | {} | {} |\n", cell.meshes,
               100.0 * cell.scatter, cell.pre_asymptotic, cell.outlier ? "one" : "none", 100.0 * finest / draws,
               100.0 * least_covered, exaggeration[exaggeration.size() / 2], 100.0 * determined / draws,
               any ? fmt::format("{:.0f}", 100.0 * order / determined) : "",
               any ? fmt::format("{:.0f}", 100.0 * limit / determined) : "");
    std::fflush(stdout);
  }
};

struct Family {
  std::vector<double> orders, ratios, scatters, pre_asymptotic;
};

Row visit_row(const Family& family, Cell cell, int draws) {
  Row row;
  for (const double order : family.orders)
    for (const double ratio : family.ratios) {
      cell.order = order;
      cell.ratio = ratio;
      const Count counted = count(cell, draws);
      expect_covers(cell, counted);
      row.add(counted);
    }
  return row;
}

std::vector<Cell> rows_of(const Family& family, int meshes) {
  std::vector<Cell> out;
  for (const double scatter : family.scatters)
    for (const double pre_asymptotic : family.pre_asymptotic)
      for (const bool outlier : {false, true}) out.push_back({meshes, 0.0, 0.0, scatter, pre_asymptotic, outlier});
  return out;
}

class FitCoverage : public testing::TestWithParam<int> {};  // by the number of meshes

TEST_P(FitCoverage, IsWhatTheIntervalsPromise) {
  const char* asked = std::getenv("CLEFT_COVERAGE_DRAWS");
  const Family all{{0.5, 1.0, 2.0, 3.0}, {1.3, 1.5, 2.0}, {0.0, 0.01, 0.05}, {0.3, 1.0}};
  const Family some{{0.5, 2.0}, {1.3, 2.0}, {0.0, 0.01, 0.05}, {1.0}};
  const Family& family = asked != nullptr ? all : some;
  const int draws = asked != nullptr ? std::max(1, std::atoi(asked)) : GetParam() > 5 ? 5 : 12;
  Row smooth, scattered;  // sums over rows, so that there are enough that are determined to tell shares of
  for (const Cell& cell : rows_of(family, GetParam())) {
    Row row = visit_row(family, cell, draws);
    (cell.scatter > 0.0 ? scattered : smooth).add(row);
    if (asked != nullptr) row.print(cell);
  }
  EXPECT_GE(smooth.finest + scattered.finest, 0.9 * (smooth.draws + scattered.draws));
  const int meshes = GetParam();
  EXPECT_GE(smooth.determined, meshes > 5 ? 0.2 * smooth.draws : 0.0) << "enough to tell shares of";
  EXPECT_LE(smooth.determined, meshes < 5 ? 0 : smooth.draws);
  EXPECT_LE(scattered.determined, 0.002 * scattered.draws) << "which is luck";
  EXPECT_GE(smooth.order + scattered.order, 0.85 * (smooth.determined + scattered.determined));
  EXPECT_GE(smooth.limit + scattered.limit, 0.9 * (smooth.determined + scattered.determined))
      << "nearer than the finest result";
}

INSTANTIATE_TEST_SUITE_P(Meshes, FitCoverage, testing::Values(3, 4, 5, 6, 7, 8), testing::PrintToStringParamName());

// Draws with scatter of 1 % that happen to look like an order, and not like theirs.
TEST(FitCoverageOfLuck, IsNotCalledAnOrder) {
  const std::pair<Cell, unsigned> lucky[] = {
      {{5, 1.0, 2.0, 0.01, 0.3, false}, 121}, {{5, 0.5, 2.0, 0.01, 0.3, true}, 125},
      {{5, 1.0, 2.0, 0.01, 0.3, false}, 14},  {{6, 1.0, 2.0, 0.01, 0.3, false}, 108},
      {{6, 0.5, 1.3, 0.01, 0.3, true}, 106},  {{6, 2.0, 1.5, 0.01, 0.3, true}, 106},
      {{7, 0.5, 2.0, 0.01, 0.3, false}, 23},  {{8, 0.5, 2.0, 0.01, 1.0, true}, 131}};
  for (const auto& [cell, seed] : lucky) {
    const Drawn drawn = draw(cell, seed);
    const LimitFit fit = fit_limit(drawn.h, drawn.value);
    EXPECT_FALSE(fit.determined) << cell.meshes << " meshes: order " << fit.order << " +- " << fit.order_pm;
    EXPECT_FALSE(fit.remark.empty());
  }
}

}  // namespace
}  // namespace cleft::convergence
