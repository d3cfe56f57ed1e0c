#include "fit_sequence.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace cleft::convergence {
namespace {

// Results of equal solutions differ by what their linear systems leave, over the largest result.
constexpr double kRounding = 1e-11;
constexpr double kSteepest = 12.0;  // of observed orders
constexpr double kFlat = 1e-6;      // an observed order of 0
constexpr std::size_t kRecent = 4;  // meshes that tell the class: coarse ones may behave as they like

void check(std::span<const double> h, std::span<const double> value, double reference_h) {
  if (h.size() != value.size() || h.size() < 2) throw std::invalid_argument("a fit needs at least two results");
  for (std::size_t k = 0; k < h.size(); ++k) {
    if (!(h[k] > 0.0) || !std::isfinite(h[k])) throw std::invalid_argument("element sizes must be positive");
    if (!std::isfinite(value[k])) throw std::invalid_argument("results must be finite");
    if (h[k] <= reference_h) throw std::invalid_argument("the reference must be finer");
    for (std::size_t l = 0; l < k; ++l)
      if (h[k] == h[l]) throw std::invalid_argument("element sizes must be distinct");
  }
  const auto [low, high] = std::minmax_element(value.begin(), value.end());
  if (!std::isfinite(*high - *low)) throw std::invalid_argument("results must have finite differences");
}

// (from^p - to^p) / p, which is a logarithm at p = 0; `to` may be 0.
double span_of(double from, double to, double p) {
  if (to == 0.0) return std::pow(from, p);
  if (std::fabs(p) < 1e-9) return std::log(from / to);
  return (std::pow(from, p) - std::pow(to, p)) / p;
}

// The order at which step k + 1 is `ratio` of step k: the ratio falls with the order.
double order_with_ratio(const Sequence& s, std::size_t k, double ratio) {
  double low = -kSteepest, high = kSteepest;
  for (int round = 0; round < 60; ++round) {
    const double middle = 0.5 * (low + high);
    (ratio_of_steps(s, k, middle) > ratio ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

Sequence Sequence::finest(std::size_t count) const {
  Sequence out = *this;
  const auto coarse = static_cast<std::ptrdiff_t>(size() - std::min(count, size()));
  out.h.erase(out.h.begin(), out.h.begin() + coarse);
  out.value.erase(out.value.begin(), out.value.begin() + coarse);
  return out;
}

Sequence sequence_of(std::span<const double> h, std::span<const double> value, const FitOptions& options) {
  check(h, value, options.reference_h);
  std::vector<std::size_t> order(h.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return h[a] > h[b]; });
  Sequence out;
  out.has_limit = !options.limit;
  out.reference = options.reference_h;
  const double limit = options.limit.value_or(0.0);
  double largest = std::fabs(limit);
  for (const double v : value) largest = std::fmax(largest, std::fabs(v));
  // distances that are known as such have no larger number behind them
  out.rounding = options.limit == 0.0 ? 0.0 : kRounding * largest;
  for (const std::size_t k : order) {
    if (options.limit && std::fabs(value[k] - limit) <= out.rounding) continue;
    out.h.push_back(h[k]);
    out.value.push_back(value[k] - limit);
  }
  return out;
}

std::vector<double> steps_of(const Sequence& s) {
  std::vector<double> out = s.value;
  if (s.has_limit) {
    std::adjacent_difference(s.value.begin(), s.value.end(), out.begin());
    out.erase(out.begin());
  }
  for (double& step : out)
    if (std::fabs(step) <= s.rounding) step = 0.0;
  return out;
}

double ratio_of_steps(const Sequence& s, std::size_t k, double p) {
  if (!s.has_limit) return span_of(s.h[k + 1], s.reference, p) / span_of(s.h[k], s.reference, p);
  return span_of(s.h[k + 1], s.h[k + 2], p) / span_of(s.h[k], s.h[k + 1], p);
}

SeriesClass class_of(const Sequence& s) {
  const auto all = steps_of(s);
  if (!s.has_limit && all.empty()) return SeriesClass::Exact;
  if (all.size() < 2) return SeriesClass::TooFew;
  const std::span steps = std::span(all).last(std::min(s.has_limit ? kRecent - 1 : kRecent, all.size()));
  if (steps[steps.size() - 1] == 0.0 && steps[steps.size() - 2] == 0.0) return SeriesClass::Exact;
  bool rises = false, falls = false;
  for (const double step : steps) rises |= step > 0.0, falls |= step < 0.0;
  if (rises && falls) return SeriesClass::Oscillating;
  return observed_orders(s).back() <= kFlat ? SeriesClass::Diverging : SeriesClass::Monotone;
}

std::vector<double> observed_orders(const Sequence& s) {
  const auto steps = steps_of(s);
  std::vector<double> out;
  for (std::size_t k = 0; k + 1 < steps.size(); ++k) {
    const bool tells = steps[k] * steps[k + 1] > 0.0;
    out.push_back(tells ? order_with_ratio(s, k, steps[k + 1] / steps[k]) : kNotKnown);
  }
  return out;
}

}  // namespace cleft::convergence
