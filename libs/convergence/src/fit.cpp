#include "cleft/convergence/fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "fit_posterior.hpp"
#include "fit_refine.hpp"
#include "fit_sequence.hpp"

namespace cleft::convergence {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kLeastMeshes = 4;  // that may determine an order
constexpr double kOrderKnownTo = 0.35;   // of the order
constexpr double kLimitKnownTo = 0.5;    // of the finest result's distance from it
constexpr double kSafety = 1.25, kSafetyOfThree = 3.0;

LimitFit nothing_known() {
  LimitFit out;
  out.asymptotic_ratio = out.limit = out.limit_pm = out.factor = out.order = out.order_pm = kUnknown;
  out.scatter = out.finest_pm = out.safety = kUnknown;
  return out;
}

bool holds(const Interval& interval, double value) { return interval.low <= value && value <= interval.high; }

double farthest(const Interval& interval, double value) {
  return std::fmax(std::fabs(interval.low - value), std::fabs(interval.high - value));
}

struct Windowed {
  Posterior posterior;
  Draw answer;
  std::size_t window = 0;
};

bool agree(const Windowed& larger, const Windowed& smaller, const Sequence& s) {
  return holds(smaller.posterior.order, larger.answer.order) &&
         (!s.has_limit || holds(smaller.posterior.limit, larger.answer.limit));
}

// The largest window of finest meshes whose answer lies in the intervals of all smaller ones (Lepski's rule): as many
// meshes as there are before the coarse ones contradict the fine ones.
Windowed choose_window(const Sequence& s) {
  std::vector<Windowed> smaller;
  Windowed chosen;
  for (std::size_t window = std::min(kLeastMeshes, s.size()); window <= s.size(); ++window) {
    const Sequence finest = s.finest(window);
    Windowed next{posterior_of(finest), {}, window};
    next.answer = most_probable(finest, next.posterior);
    if (std::ranges::all_of(smaller, [&](const Windowed& other) { return agree(next, other, s); })) chosen = next;
    smaller.push_back(next);
  }
  return chosen;
}

// Root mean square of what C h^p leaves.
double scatter_of(const Sequence& s, const LimitFit& fit) {
  const double limit = s.has_limit ? fit.limit : 0.0;
  const double at_reference = s.reference > 0.0 ? std::pow(s.reference, fit.order) : 0.0;
  double squares = 0.0;
  for (std::size_t k = 0; k < s.size(); ++k)
    squares += std::pow(s.value[k] - limit - fit.factor * (std::pow(s.h[k], fit.order) - at_reference), 2);
  return std::sqrt(squares / static_cast<double>(s.size()));
}

// Why the data do not determine the answer; empty where they do.
std::string doubt(const Sequence& s, const LimitFit& fit, const Interval& order) {
  const std::size_t meshes = s.size() + (s.reference > 0.0 ? 1 : 0);
  if (meshes < kLeastMeshes) return fmt::format("{} meshes do not determine an order: {} do", meshes, kLeastMeshes);
  if (!s.has_limit && fit.kind == SeriesClass::Oscillating) return "the results cross the limit";
  if (fit.kind == SeriesClass::Diverging) return "the differences do not get smaller on the finest meshes";
  if (order.low <= kLeastOrder * 1.01)
    return fmt::format("the order may be below {:.2g}, so that the limit may be anywhere", kLeastOrder);
  if (order.high >= kMostOrder * 0.99) return fmt::format("the order may be above {:.2g}", kMostOrder);
  if (fit.order_pm > kOrderKnownTo * fit.order) return fmt::format("the order is uncertain by {:.2g}", fit.order_pm);
  if (s.has_limit && fit.limit_pm > kLimitKnownTo * std::fabs(fit.limit - s.value.back()))
    return "the limit is not known better than by the finest result";
  return "";
}

void fit_windows(const Sequence& s, LimitFit& out) {
  const auto [posterior, answer, window] = choose_window(s);
  out.window = window;
  out.order = answer.order;
  out.order_pm = farthest(posterior.order, answer.order);
  if (s.has_limit) {
    out.limit = answer.limit;
    out.limit_pm = farthest(posterior.limit, answer.limit);
    out.safety = s.size() < kLeastMeshes ? kSafetyOfThree : kSafety;
    out.finest_pm = out.safety * posterior.finest_error;
  }
  const auto steps = steps_of(s);
  const std::size_t last = steps.size() - 2;
  out.asymptotic_ratio = steps[last + 1] / steps[last] / ratio_of_steps(s, last, out.order);
  out.factor = answer.factor * std::pow(s.h[s.size() - window], -answer.order);
  out.scatter = scatter_of(s.finest(window), out);
  out.remark = doubt(s, out, posterior.order);
  out.determined = out.remark.empty();
}

// Equal results have a limit and no order.
void take_exact(const Sequence& s, LimitFit& out) {
  out.window = std::min<std::size_t>(3, s.size());
  out.remark = s.has_limit ? "the results are equal but for rounding: they have no order" : "the results are exact";
  if (!s.has_limit) return;
  const auto fine = s.finest(out.window).value;
  const auto [low, high] = std::minmax_element(fine.begin(), fine.end());
  out.limit = s.value.back();
  out.limit_pm = out.finest_pm = std::fmax(*high - *low, s.rounding);
  out.scatter = *high - *low;
}

}  // namespace

const char* name_of(SeriesClass kind) {
  switch (kind) {
    case SeriesClass::Exact:
      return "exact to rounding";
    case SeriesClass::Monotone:
      return "monotone";
    case SeriesClass::Oscillating:
      return "oscillating";
    case SeriesClass::Diverging:
      return "diverging";
    case SeriesClass::TooFew:
      break;
  }
  return "too few meshes";
}

LimitFit fit_limit(std::span<const double> h, std::span<const double> value, const FitOptions& options) {
  Sequence s = sequence_of(h, value, options).finest(kMostMeshes);
  LimitFit out = nothing_known();
  out.kind = class_of(s);
  out.observed_order = observed_orders(s);
  if (out.kind == SeriesClass::TooFew)
    out.remark = fmt::format("{} meshes show nothing of an order", s.size());
  else if (out.kind == SeriesClass::Exact)
    take_exact(s, out);
  else
    fit_windows(s, out);
  if (options.limit) out.limit = *options.limit, out.limit_pm = 0.0;
  return out;
}

}  // namespace cleft::convergence
