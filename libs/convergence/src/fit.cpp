#include "cleft/convergence/fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "fit_posterior.hpp"
#include "fit_refine.hpp"
#include "fit_sequence.hpp"

namespace cleft::convergence {
namespace {

constexpr std::size_t kLeastMeshes = 4;  // that may determine an order
constexpr double kOrderKnownTo = 0.35;   // of the order
constexpr double kLimitKnownTo = 0.5;    // of the finest result's distance from it
constexpr double kSafety = 1.25, kSafetyUndetermined = 2.0, kSafetyOfThree = 3.0;
constexpr double kContradiction = 1.5;  // of a smaller window's half width
// Probabilities of scatter of 1 % or more from which on an order may be luck: by the window of the answer, where that
// is of five meshes or fewer, and by another window, which fits it less.
constexpr double kMayScatter = 0.01, kMayScatterOfFive = 0.001, kOtherMayScatter = 0.2;

double farthest(const Interval& interval, double value) {
  return std::fmax(std::fabs(interval.low - value), std::fabs(interval.high - value));
}

struct Windowed {
  Posterior posterior;
  Draw answer;

  double order_pm() const { return farthest(posterior.order, answer.order); }
  double limit_pm() const { return farthest(posterior.limit, answer.limit); }
};

bool contradicts(const Windowed& smaller, const Windowed& larger) {
  return std::fabs(larger.answer.order - smaller.answer.order) > kContradiction * smaller.order_pm() ||
         std::fabs(larger.answer.limit - smaller.answer.limit) > kContradiction * smaller.limit_pm();
}

// Answers of the finest meshes: four (or what there is), five, and so on.
std::vector<Windowed> windows_of(const Sequence& s) {
  std::vector<Windowed> out;
  for (std::size_t meshes = std::min(kLeastMeshes, s.size()); meshes <= s.size(); ++meshes) {
    const Sequence finest = s.finest(meshes);
    const Posterior posterior = posterior_of(finest);
    out.push_back({posterior, most_probable(finest, posterior)});
  }
  return out;
}

// The largest window that none of the smaller ones contradicts (Lepski's rule): as many meshes as there are before the
// coarse ones do not fit to the fine ones.
std::size_t choose(const std::vector<Windowed>& windows) {
  for (std::size_t k = windows.size(); k-- > 1;)
    if (std::none_of(windows.begin(), windows.begin() + static_cast<std::ptrdiff_t>(k),
                     [&](const Windowed& smaller) { return contradicts(smaller, windows[k]); }))
      return k;
  return 0;
}

// Whether it may be scatter that looks like an order: by this window and the next smaller one; by the next larger one
// where that is of four meshes, which do not tell.
bool may_be_luck(const std::vector<Windowed>& windows, std::size_t chosen) {
  const bool is_small = chosen < 2;  // windows are of four meshes, five, and so on
  const std::size_t other = is_small ? std::min(chosen + 1, windows.size() - 1) : chosen - 1;
  return windows[chosen].posterior.scattered >= (is_small ? kMayScatterOfFive : kMayScatter) ||
         windows[other].posterior.scattered >= kOtherMayScatter;
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
  if (fit.window < kLeastMeshes + 1 && fit.window < s.size())
    return fmt::format("the coarse meshes contradict the finest {}, which are too few alone", fit.window);
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

// The largest error is that of the next larger window, too: a mesh that is left out by mistake does no harm.
void fit_windows(const Sequence& s, LimitFit& out) {
  const auto windows = windows_of(s);
  const std::size_t chosen = choose(windows);
  const auto& [posterior, answer] = windows[chosen];
  out.window = s.size() - (windows.size() - 1 - chosen);
  out.order = answer.order;
  out.order_pm = windows[chosen].order_pm();
  if (s.has_limit) {
    out.limit = answer.limit;
    out.limit_pm = windows[chosen].limit_pm();
  }
  const auto steps = steps_of(s);
  const std::size_t last = steps.size() - 2;
  if (steps[last] != 0.0) out.asymptotic_ratio = steps[last + 1] / steps[last] / ratio_of_steps(s, last, out.order);
  out.factor = answer.factor * std::pow(s.h[s.size() - out.window], -answer.order);
  out.scatter = scatter_of(s.finest(out.window), out);
  out.remark = doubt(s, out, posterior.order);
  if (out.remark.empty() && s.has_limit && may_be_luck(windows, chosen))
    out.remark = "scatter of 1 % or more may look like this order";
  out.determined = out.remark.empty();
  if (!s.has_limit) return;
  const auto& larger = windows[std::min(chosen + 1, windows.size() - 1)];
  out.safety = s.size() < kLeastMeshes ? kSafetyOfThree : out.determined ? kSafety : kSafetyUndetermined;
  out.finest_pm = out.safety * std::fmax(posterior.finest_error, larger.posterior.finest_error);
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
  LimitFit out;
  out.kind = class_of(s);
  out.observed_order = observed_orders(s);
  if (out.kind == SeriesClass::TooFew)
    out.remark = s.has_limit ? fmt::format("{} meshes show nothing of an order", s.size())
                             : "one error above rounding shows nothing of an order";
  else if (out.kind == SeriesClass::Exact)
    take_exact(s, out);
  else
    fit_windows(s, out);
  if (options.limit) out.limit = *options.limit, out.limit_pm = 0.0;
  return out;
}

}  // namespace cleft::convergence
