#include "fit_posterior.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace cleft::convergence {
namespace {

using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostMeshes, 1>;
using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMostMeshes, kMostMeshes>;

struct Weighted {
  double value, weight;
};

// Priors. log p has the density 1/p: low orders are the dangerous ones. Deviations of the terms that
// follow h^p, of the scatter and of an outlier are over C.
constexpr int kOrders = 24;           // points of a scan over p
constexpr double kFinestStep = 1e-4;  // of log p
constexpr std::array kPreAsymptotic{Weighted{0.03, 0.2}, Weighted{0.15, 0.3}, Weighted{0.6, 0.4}, Weighted{2.0, 0.1}};
constexpr std::array kScatter{Weighted{1e-6, 1.0}, Weighted{1e-5, 1.0}, Weighted{1e-4, 1.0}, Weighted{1e-3, 1.0},
                              Weighted{0.01, 1.0}, Weighted{0.03, 0.6}, Weighted{0.1, 0.2},  Weighted{0.3, 0.03}};
constexpr std::array kOutlier{0.2, 0.8};
constexpr double kOutlierShare = 0.1;  // probability that there is one
constexpr std::size_t kLeastForOutlier = 4;

constexpr double kLargeScatter = 0.01;  // of t: from here on its draws may look like an order

constexpr double kNegligible = 9.0;  // of a logarithm of probabilities

// Nodes of a normal distribution and what lies around each of them.
constexpr std::array kNormal{Weighted{-2.2, 0.040}, Weighted{-1.3, 0.125}, Weighted{-0.65, 0.207}, Weighted{0.0, 0.256},
                             Weighted{0.65, 0.207}, Weighted{1.3, 0.125},  Weighted{2.2, 0.040}};

// A part of the posterior in which the limit is normal.
struct Part {
  double log_weight, deviation;
  Draw draw;
};

// Sums over the meshes, weighted by an inverse covariance: of 1, of the results y and of the model g.
struct Sums {
  double one, y, g, yy, yg, gg;
  double log_root;  // of the covariance's determinant

  // without what the vectors of mesh k say, to the degree d = 1 / (1/variance + precision_kk)
  Sums without(double one_k, double y_k, double g_k, double d) const {
    return {one - one_k * one_k * d,
            y - one_k * y_k * d,
            g - one_k * g_k * d,
            yy - y_k * y_k * d,
            yg - y_k * g_k * d,
            gg - g_k * g_k * d,
            log_root};
  }
};

// Sums over p, A, t, the outlier and C; lengths and results in units of their largest.
class Scan {
 public:
  // `y` are the results in the unit of the sums.
  Scan(const Sequence& s, const std::vector<double>& y)
      : x_(Eigen::Map<const Eigen::VectorXd>(s.h.data(), static_cast<Eigen::Index>(s.size())) / s.h[0]),
        y_(Eigen::Map<const Eigen::VectorXd>(y.data(), static_cast<Eigen::Index>(y.size()))),
        has_limit_(s.has_limit),
        reference_(s.reference / s.h[0]) {}

  double step() const { return step_; }  // of log p between the points of the last scan

  // All parts that count. Scans p, and again more finely where most of the probability lies at a few of the points.
  std::vector<Part> parts() {
    double low = std::log(kLeastOrder), high = std::log(kMostOrder);
    for (;;) {
      parts_.clear();
      best_ = -std::numeric_limits<double>::infinity();
      step_ = (high - low) / kOrders;
      for (int k = 0; k < kOrders; ++k) add_order(std::exp(low + (k + 0.5) * step_));
      const double least = best_ - kNegligible;
      std::erase_if(parts_, [least](const Part& part) { return part.log_weight < least; });
      const auto [first, last] = std::minmax_element(
          parts_.begin(), parts_.end(), [](const Part& a, const Part& b) { return a.draw.order < b.draw.order; });
      const double from = std::log(first->draw.order), to = std::log(last->draw.order);
      if (to - from > 7.5 * step_ || step_ < kFinestStep) return std::move(parts_);
      low = std::fmax(from - 1.5 * step_, std::log(kLeastOrder));
      high = std::fmin(to + 1.5 * step_, std::log(kMostOrder));
    }
  }

 private:
  Vector power(double p) const { return x_.array().pow(p) - (reference_ > 0.0 ? std::pow(reference_, p) : 0.0); }

  void add_order(double p) {
    const Vector g = power(p), second = power(p + 1.0), third = power(p + 2.0);
    const Matrix terms = second * second.transpose() + third * third.transpose();
    const Vector unit = has_limit_ ? Vector::Ones(g.size()) : g;  // of the scatter
    for (const auto& [deviation, share] : kPreAsymptotic)
      for (const auto& [scatter, portion] : kScatter) {
        Matrix covariance = deviation * deviation * terms;
        covariance.diagonal() += (scatter * unit).cwiseAbs2();
        draw_ = {.order = p, .pre_asymptotic = deviation, .scatter = scatter};
        add_covariance(g, unit, covariance, std::log(share * portion / p));
      }
  }

  void add_covariance(const Vector& g, const Vector& unit, const Matrix& covariance, double log_prior) {
    const Eigen::LLT<Matrix> factors(covariance);
    const Matrix precision = factors.solve(Matrix::Identity(g.size(), g.size()));
    const Vector one = precision.rowwise().sum(), y = precision * y_, model = precision * g;
    double log_root = 0.0;
    for (Eigen::Index i = 0; i < g.size(); ++i) log_root += std::log(factors.matrixLLT()(i, i));
    const Sums all{one.sum(), y.sum(), model.sum(), y_.dot(y), y_.dot(model), g.dot(model), log_root};
    const auto meshes = static_cast<std::size_t>(g.size());
    const bool may_have_outlier = meshes >= kLeastForOutlier;
    add(all, log_prior + (may_have_outlier ? std::log(1.0 - kOutlierShare) : 0.0));
    if (!may_have_outlier) return;
    log_prior += std::log(kOutlierShare / static_cast<double>(meshes * kOutlier.size()));
    for (Eigen::Index k = 0; k < g.size(); ++k)
      for (const double size : kOutlier) {
        const double variance = size * size * unit[k] * unit[k];
        Sums rest = all.without(one[k], y[k], model[k], 1.0 / (1.0 / variance + precision(k, k)));
        rest.log_root += 0.5 * std::log(1.0 + variance * precision(k, k));
        draw_.outlier = size;
        draw_.outlier_at = static_cast<std::size_t>(k);
        add(rest, log_prior);
      }
  }

  // Integrates Q0, and 1/C by points around both of its modes: the density is that of a normal one times a power.
  void add(const Sums& s, double log_prior) {
    const double mean_y = has_limit_ ? s.y / s.one : 0.0, mean_g = has_limit_ ? s.g / s.one : 0.0;
    const double yy = std::fmax(s.yy - s.y * mean_y, std::numeric_limits<double>::min());
    const double yg = s.yg - s.y * mean_g, gg = s.gg - s.g * mean_g;
    const double exponent = static_cast<double>(x_.size()) - (has_limit_ ? 2.0 : 1.0);
    const double base = log_prior - s.log_root - (has_limit_ ? 0.5 * std::log(s.one) : 0.0);
    const double root = std::sqrt(yg * yg + 4.0 * yy * exponent);
    for (const double sign : {1.0, -1.0}) {
      const double along = sign * yg;
      const double mode = sign * (along > 0.0 ? (along + root) / (2.0 * yy) : 2.0 * exponent / (root - along));
      const auto log_density = [&](double u) {
        return base - 0.5 * (yy * u * u - 2.0 * yg * u + gg) + exponent * std::log(std::fabs(u));
      };
      const double width = 1.0 / std::sqrt(yy + exponent / (mode * mode));
      best_ = std::fmax(best_, log_density(mode) + std::log(width));
      if (log_density(mode) + std::log(width) < best_ - kNegligible) continue;
      for (int node = -2; node <= 2; ++node) {
        const double u = mode + 1.1 * node * width;
        if (u * mode <= 0.0) continue;
        draw_.factor = 1.0 / u;
        draw_.limit = mean_y - mean_g / u;
        parts_.push_back({log_density(u) + std::log(width), 1.0 / std::fabs(u) / std::sqrt(s.one), draw_});
      }
    }
  }

  Vector x_, y_;
  bool has_limit_;
  double reference_, best_ = 0.0, step_ = 0.0;
  Draw draw_;  // whose parts are being added
  std::vector<Part> parts_;
};

// The value below which `share` of the weight lies; sorts only what it must.
double quantile(std::vector<Weighted>& all, double share) {
  auto first = all.begin(), last = all.end();
  double below = 0.0;
  for (const auto& each : all) below += share * each.weight;
  while (last - first > 1) {
    const auto middle = first + (last - first) / 2;
    std::nth_element(first, middle, last, [](const Weighted& a, const Weighted& b) { return a.value < b.value; });
    double left = 0.0;
    for (auto each = first; each != middle; ++each) left += each->weight;
    if (below <= left) {
      last = middle;
    } else {
      below -= left;
      first = middle;
    }
  }
  return first->value;
}

Interval interval_of(std::vector<Weighted>& all) { return {quantile(all, 0.025), quantile(all, 0.975)}; }

// Each point of the scan stands for what lies around it.
Interval order_of(const std::vector<Part>& parts, double largest, double step) {
  std::vector<Weighted> orders;
  for (const auto& part : parts) orders.push_back({part.draw.order, std::exp(part.log_weight - largest)});
  const Interval at_points = interval_of(orders);
  return {at_points.low * std::exp(-0.5 * step), at_points.high * std::exp(0.5 * step)};
}

double share_of_large_scatter(const std::vector<Part>& parts, double largest) {
  double large = 0.0, all = 0.0;
  for (const auto& part : parts) {
    const double weight = std::exp(part.log_weight - largest);
    all += weight;
    if (part.draw.scatter >= kLargeScatter) large += weight;
  }
  return large / all;
}

std::vector<Weighted> limits_of(const std::vector<Part>& parts, double largest) {
  std::vector<Weighted> out;
  for (const auto& part : parts)
    for (const auto& [node, share] : kNormal)
      out.push_back({part.draw.limit + node * part.deviation, share * std::exp(part.log_weight - largest)});
  return out;
}

}  // namespace

Posterior posterior_of(const Sequence& sequence) {
  const auto [low, high] = std::minmax_element(sequence.value.begin(), sequence.value.end());
  const double origin = sequence.has_limit ? sequence.value.back() : 0.0;
  const double unit = sequence.has_limit ? *high - *low : std::fmax(std::fabs(*low), std::fabs(*high));
  std::vector<double> scaled;
  for (const double v : sequence.value) scaled.push_back((v - origin) / unit);
  Scan scan(sequence, scaled);
  const auto parts = scan.parts();
  const auto& best = *std::ranges::max_element(parts, {}, &Part::log_weight);
  Posterior out;
  out.best = best.draw;
  out.best.factor *= unit;
  out.order = order_of(parts, best.log_weight, scan.step());
  out.scattered = share_of_large_scatter(parts, best.log_weight);
  if (!sequence.has_limit) return out;
  out.best.limit = origin + unit * out.best.limit;
  auto limits = limits_of(parts, best.log_weight);
  const Interval limit = interval_of(limits);
  out.limit = {origin + unit * limit.low, origin + unit * limit.high};
  for (auto& each : limits) each.value = std::fabs(each.value);
  out.finest_error = unit * quantile(limits, 0.95);
  return out;
}

}  // namespace cleft::convergence
