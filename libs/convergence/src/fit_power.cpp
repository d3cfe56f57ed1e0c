#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <stdexcept>
#include <vector>

#include "cleft/convergence/fit.hpp"

namespace cleft::convergence {
namespace {

constexpr std::size_t kLeastSizes = 3, kSizesThatDetermine = 4;
constexpr double kExponentKnownTo = 0.25;

struct Logs {
  std::vector<double> x, y;

  Logs without(std::size_t k) const {
    Logs out = *this;
    out.x.erase(out.x.begin() + static_cast<std::ptrdiff_t>(k));
    out.y.erase(out.y.begin() + static_cast<std::ptrdiff_t>(k));
    return out;
  }
};

// y = at_zero + slope x by least squares.
struct Line {
  double at_zero = 0.0, slope = 0.0;
  double spread = 0.0;   ///< sum of (x - mean)^2
  double squares = 0.0;  ///< of what it leaves
};

Line line_through(const Logs& logs) {
  const auto n = static_cast<double>(logs.x.size());
  double mean_x = 0.0, mean_y = 0.0, product = 0.0;
  for (const double x : logs.x) mean_x += x / n;
  for (const double y : logs.y) mean_y += y / n;
  Line out;
  for (std::size_t k = 0; k < logs.x.size(); ++k) {
    out.spread += (logs.x[k] - mean_x) * (logs.x[k] - mean_x);
    product += (logs.x[k] - mean_x) * (logs.y[k] - mean_y);
  }
  out.slope = product / out.spread;
  out.at_zero = mean_y - out.slope * mean_x;
  for (std::size_t k = 0; k < logs.x.size(); ++k)
    out.squares += std::pow(logs.y[k] - out.at_zero - out.slope * logs.x[k], 2);
  return out;
}

// 97.5 % quantiles of Student's t for 1, 2, ... degrees of freedom.
double student(std::size_t freedom) {
  constexpr std::array kTable{12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228};
  if (freedom <= kTable.size()) return kTable[freedom - 1];
  return 1.960 + 2.4 / static_cast<double>(freedom);  // within 1 % from here on
}

// The larger of the scatter's 95 % and of what any one cost does to the slope.
double uncertainty_of(const Logs& logs, const Line& line) {
  const std::size_t freedom = logs.x.size() - 2;
  double out = student(freedom) * std::sqrt(line.squares / static_cast<double>(freedom) / line.spread);
  for (std::size_t k = 0; k < logs.x.size(); ++k)
    if (const Line rest = line_through(logs.without(k)); rest.spread > 0.0)
      out = std::fmax(out, std::fabs(rest.slope - line.slope));
  return out;
}

Logs logs_of(std::span<const double> x, std::span<const double> cost) {
  if (x.size() != cost.size()) throw std::invalid_argument("a cost each size");
  Logs out;
  for (std::size_t k = 0; k < x.size(); ++k) {
    if (!(x[k] > 0.0) || !std::isfinite(x[k])) throw std::invalid_argument("sizes must be positive");
    if (!(cost[k] >= 0.0) || !std::isfinite(cost[k])) throw std::invalid_argument("costs must be finite, 0 or more");
    if (cost[k] == 0.0) continue;
    out.x.push_back(std::log(x[k]));
    out.y.push_back(std::log(cost[k]));
  }
  return out;
}

}  // namespace

PowerFit fit_power(std::span<const double> x, std::span<const double> cost) {
  const Logs logs = logs_of(x, cost);
  const std::size_t sizes = std::set(logs.x.begin(), logs.x.end()).size();
  PowerFit out;
  if (sizes < kLeastSizes) {
    out.remark = "an exponent needs three meshes that cost something";
    return out;
  }
  const Line line = line_through(logs);
  out.order = line.slope;
  out.factor = std::exp(line.at_zero);
  out.order_pm = uncertainty_of(logs, line);
  if (sizes < kSizesThatDetermine)
    out.remark = "three meshes do not determine an exponent";
  else if (out.order_pm > kExponentKnownTo)
    out.remark = "these meshes do not determine the exponent";
  out.determined = out.remark.empty();
  return out;
}

}  // namespace cleft::convergence
