#include "cleft/convergence/fit.hpp"

#include <ceres/ceres.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <vector>

namespace cleft::convergence {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr std::array kStarts{0.5, 1.0, 2.0, 3.5};  // of p

constexpr int kRounds = 5;  // of scatter and robust fit, each by the other

// 97.5 % quantiles of Student's t for 1, 2, ... degrees of freedom.
double student(std::size_t freedom) {
  constexpr std::array kTable{12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228};
  if (freedom <= kTable.size()) return kTable[freedom - 1];
  return 1.960 + 2.4 / static_cast<double>(freedom);  // within 1 % from here on
}

// y = Q0 + C x^p with x = h / h_max
struct WithLimit {
  double x, y;
  template <class T>
  bool operator()(const T* limit, const T* factor, const T* order, T* residual) const {
    using std::pow;
    residual[0] = limit[0] + factor[0] * pow(T(x), order[0]) - y;
    return true;
  }
};

// log |y| = log C + p log x, for a limit that is known, or log C + log (x^p - finest^p)
struct Straight {
  double x, y, finest;
  template <class T>
  T power(const T& order) const {
    using std::log, std::pow;
    return finest > 0.0 ? T(log(pow(T(x), order) - pow(T(finest), order))) : T(order * log(x));
  }
  template <class T>
  bool operator()(const T* factor, const T* order, T* residual) const {
    residual[0] = factor[0] + power(order[0]) - y;
    return true;
  }
};

// What is fitted: {Q0, C, p} or {log C, p}. One parameter block a number.
struct Solution {
  std::array<double, 3> parameter{};
  std::vector<double> residual;
  double cost = std::numeric_limits<double>::infinity();
  std::array<double, 3> variance{kNaN, kNaN, kNaN};  // per unit variance of the residuals; NaN if singular
};

// Scatter by the median of the residuals, which an outlier hardly moves. As many as there are parameters may vanish by
// the fit alone and do not count.
double scatter_of(const std::vector<double>& residual, std::size_t parameters) {
  std::vector<double> size;
  for (const double r : residual) size.push_back(std::fabs(r));
  std::sort(size.begin(), size.end());
  return 1.4826 * size[(parameters + size.size()) / 2];
}

struct Fit {
  std::vector<double> x, y;
  bool free_limit = true;
  double finest = 0.0;  // reference_h / h_max
  FitOptions options;

  std::size_t parameters() const { return free_limit ? 3 : 2; }
  std::size_t order_at() const { return parameters() - 1; }

  Solution solve(const Solution& start, double huber) const {
    Solution out = start;
    auto& p = out.parameter;
    ceres::Problem problem;
    for (std::size_t k = 0; k < x.size(); ++k) {
      ceres::LossFunction* loss = huber > 0.0 ? new ceres::HuberLoss(huber) : nullptr;
      if (free_limit)
        problem.AddResidualBlock(new ceres::AutoDiffCostFunction<WithLimit, 1, 1, 1, 1>(new WithLimit{x[k], y[k]}),
                                 loss, &p[0], &p[1], &p[2]);
      else
        problem.AddResidualBlock(new ceres::AutoDiffCostFunction<Straight, 1, 1, 1>(new Straight{x[k], y[k], finest}),
                                 loss, &p[0], &p[1]);
    }
    problem.SetParameterLowerBound(&p[order_at()], 0, options.least_order);
    problem.SetParameterUpperBound(&p[order_at()], 0, options.most_order);
    ceres::Solver::Options controls;
    controls.linear_solver_type = ceres::DENSE_QR;
    controls.logging_type = ceres::SILENT;
    controls.max_num_iterations = 500;
    controls.function_tolerance = controls.gradient_tolerance = controls.parameter_tolerance = 1e-14;
    ceres::Solver::Summary summary;
    ceres::Solve(controls, &problem, &summary);
    ceres::Problem::EvaluateOptions plain;
    plain.apply_loss_function = false;
    double half_squares = 0.0;
    problem.Evaluate(plain, &half_squares, &out.residual, nullptr, nullptr);
    out.cost = summary.final_cost;

    ceres::Covariance::Options how;
    how.algorithm_type = ceres::DENSE_SVD;
    how.apply_loss_function = true;
    ceres::Covariance covariance(how);
    std::vector<std::pair<const double*, const double*>> blocks;
    for (std::size_t k = 0; k < parameters(); ++k) blocks.emplace_back(&p[k], &p[k]);
    const bool regular = covariance.Compute(blocks, &problem);
    for (std::size_t k = 0; regular && k < parameters(); ++k)
      covariance.GetCovarianceBlock(&p[k], &p[k], &out.variance[k]);
    return out;
  }

  // Limit and factor follow from p by linear least squares: a start on the valley's floor.
  Solution start(double order) const {
    Solution s;
    s.parameter[order_at()] = order;
    const auto n = static_cast<double>(x.size());
    double sum_g = 0, sum_y = 0, sum_gg = 0, sum_gy = 0;
    for (std::size_t k = 0; k < x.size(); ++k) {
      const double g = free_limit ? std::pow(x[k], order) : 0.0;
      const double target = free_limit ? y[k] : y[k] - Straight{x[k], y[k], finest}.power(order);
      sum_g += g, sum_y += target, sum_gg += g * g, sum_gy += g * target;
    }
    if (!free_limit) {
      s.parameter[0] = sum_y / n;
      return s;
    }
    const double determinant = n * sum_gg - sum_g * sum_g;
    s.parameter[1] = (n * sum_gy - sum_g * sum_y) / determinant;
    s.parameter[0] = (sum_y - s.parameter[1] * sum_g) / n;
    return s;
  }

  Solution best() const {
    Solution best;
    for (const double order : kStarts) {
      const double inside = std::clamp(order, options.least_order, options.most_order);
      if (Solution s = solve(start(inside), 0.0); s.cost < best.cost) best = s;
    }
    if (x.size() < parameters() + 2) return best;
    // the first scatter still contains what an outlier does to the plain fit
    for (int round = 0; round < kRounds; ++round) {
      const double scatter = scatter_of(best.residual, parameters());
      if (scatter <= 1e-13) break;
      best = solve(best, 1.5 * scatter);
    }
    return best;
  }
};

void check(std::span<const double> h, std::span<const double> value, double reference_h) {
  if (h.size() != value.size() || h.size() < 2) throw std::invalid_argument("a fit needs at least two results");
  for (std::size_t k = 0; k < h.size(); ++k) {
    if (!(h[k] > 0.0) || !std::isfinite(h[k])) throw std::invalid_argument("element sizes must be positive");
    if (!std::isfinite(value[k])) throw std::invalid_argument("results must be finite");
    if (h[k] <= reference_h) throw std::invalid_argument("the reference must be finer");
    for (std::size_t l = 0; l < k; ++l)
      if (h[k] == h[l]) throw std::invalid_argument("element sizes must be distinct");
  }
}

// Half width of the confidence interval of a parameter of unit variance; NaN where nothing is left to tell.
double spread_of(const Fit& fit, const Solution& s) {
  double squares = 0.0;
  for (const double r : s.residual) squares += r * r;
  const std::size_t n = fit.x.size(), m = fit.parameters();
  return n <= m ? kNaN : std::sqrt(squares / static_cast<double>(n - m)) * student(n - m);
}

// Fills in uncertainty and verdict; `unit` are the sizes of one unit of each parameter.
void judge(const Fit& fit, const Solution& s, double limit_unit, LimitFit& out) {
  const double p = s.parameter[fit.order_at()];
  const bool exact = fit.x.size() <= fit.parameters();
  const double spread = spread_of(fit, s);
  out.order_pm = spread * std::sqrt(s.variance[fit.order_at()]);
  out.limit_pm = fit.free_limit ? spread * std::sqrt(s.variance[0]) * limit_unit : 0.0;
  const double margin = 1e-6 * (fit.options.most_order - fit.options.least_order);
  if (p <= fit.options.least_order + margin || p >= fit.options.most_order - margin)
    out.remark = fmt::format("the order runs into its bound {:.3g}", p);
  else if (std::isnan(s.variance[fit.order_at()]))
    out.remark = "the data say nothing of the order";
  else if (out.order_pm > p)
    out.remark = fmt::format("the order is uncertain by {:.2g}", out.order_pm);
  out.determined = out.remark.empty();
  if (out.determined && exact) out.remark = "as many parameters as meshes: no uncertainty";
}

}  // namespace

LimitFit fit_limit(std::span<const double> h, std::span<const double> value, const FitOptions& options) {
  check(h, value, options.reference_h);
  LimitFit out;
  out.limit_pm = out.order_pm = kNaN;
  const double h_max = *std::max_element(h.begin(), h.end());
  Fit fit;
  fit.options = options;
  fit.free_limit = !options.limit.has_value();
  double origin = 0.0, unit = 1.0;  // of the values
  if (fit.free_limit) {
    const auto [low, high] = std::minmax_element(value.begin(), value.end());
    origin = value[static_cast<std::size_t>(std::min_element(h.begin(), h.end()) - h.begin())];
    unit = *high - *low;
    out.limit = origin;
    if (unit == 0.0) out.remark = "all results are equal";
    if (h.size() < 3) out.remark = "a limit and an order need three meshes", out.limit = kNaN;
    if (!out.remark.empty()) {
      out.order = kNaN;
      return out;
    }
  } else {
    out.limit = *options.limit;
    fit.finest = options.reference_h / h_max;
  }
  bool above = false, below = false;
  for (std::size_t k = 0; k < h.size(); ++k) {
    const double distance = value[k] - out.limit;
    above |= distance > 0.0, below |= distance < 0.0;
    if (!fit.free_limit && distance == 0.0) continue;
    fit.x.push_back(h[k] / h_max);
    fit.y.push_back(fit.free_limit ? (value[k] - origin) / unit : std::log(std::fabs(distance)));
  }
  if (fit.x.size() < 2) {
    out.order = kNaN;
    out.remark = "the results are exact";
    return out;
  }
  const Solution s = fit.best();
  out.order = s.parameter[fit.order_at()];
  const double power = std::pow(h_max, -out.order);
  if (fit.free_limit) {
    out.limit = origin + unit * s.parameter[0];
    out.factor = unit * s.parameter[1] * power;
  } else {
    out.factor = (below ? -1.0 : 1.0) * std::exp(s.parameter[0]) * power;
  }
  judge(fit, s, unit, out);
  if (!fit.free_limit && above && below) {
    out.determined = false;
    out.remark = "the results cross the limit";
  }
  double squares = 0.0;
  for (std::size_t k = 0; k < h.size(); ++k) {
    const double power_of_finest = fit.finest > 0.0 ? std::pow(options.reference_h, out.order) : 0.0;
    const double left = value[k] - out.limit - out.factor * (std::pow(h[k], out.order) - power_of_finest);
    squares += left * left;
  }
  out.scatter = std::sqrt(squares / static_cast<double>(h.size()));
  return out;
}

LimitFit fit_power(std::span<const double> x, std::span<const double> cost) {
  if (x.size() != cost.size()) throw std::invalid_argument("a cost each size");
  LimitFit out;
  out.factor = out.order = out.order_pm = kNaN;
  Fit fit;
  fit.free_limit = false;
  fit.options.least_order = -fit.options.most_order;
  const double largest = x.empty() ? 1.0 : *std::max_element(x.begin(), x.end());
  for (std::size_t k = 0; k < x.size(); ++k) {
    if (!(x[k] > 0.0) || !std::isfinite(x[k])) throw std::invalid_argument("sizes must be positive");
    if (!(cost[k] >= 0.0) || !std::isfinite(cost[k])) throw std::invalid_argument("costs must be finite, 0 or more");
    if (cost[k] == 0.0) continue;
    fit.x.push_back(x[k] / largest);
    fit.y.push_back(std::log(cost[k]));
  }
  if (std::set(fit.x.begin(), fit.x.end()).size() < 3) {
    out.remark = "an exponent needs three meshes that cost something";
    return out;
  }
  const Solution s = fit.best();
  out.order = s.parameter[1];
  out.factor = std::exp(s.parameter[0]) * std::pow(largest, -out.order);
  out.order_pm = spread_of(fit, s) * std::sqrt(s.variance[1]);
  out.determined = out.order_pm <= 1.0;
  if (!out.determined) out.remark = "these meshes do not determine the exponent";
  double squares = 0.0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double left = cost[k] - out.factor * std::pow(x[k], out.order);
    if (cost[k] > 0.0) squares += left * left;
  }
  out.scatter = std::sqrt(squares / static_cast<double>(fit.x.size()));
  return out;
}

}  // namespace cleft::convergence
