// What the iterations of a run say of the tangent.
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "cleft/tangent_check/newton_rate.hpp"

namespace cleft::tangent_check {
namespace {

constexpr std::size_t kClearlyLinear = 5;  // increments in a row

// Whether an attempt that failed misses for sure. Newton's iteration is linear, too, with ratios of 1/2, where the
// tangent is singular, and there attempts fail.
bool misses(const IncrementRate& failed, const RateRequirement& required) {
  constexpr std::size_t kLong = 5;    // corrections
  constexpr double kSingular = 0.25;  // ratio of corrections
  return find(failed.rate, required) == Finding::Missed && failed.rate.corrections >= kLong &&
         failed.rate.ratios->back() < kSingular && *failed.rate.order < required.least;
}

void count(const IncrementRate& rate, const RateRequirement& required, RateVerdict& out) {
  const Finding finding = find(rate.rate, required);
  out.ends_in_failure = rate.failed;
  ++(rate.failed ? out.failed : out.increments);
  if (rate.failed && !misses(rate, required)) return;
  ++out.count[static_cast<std::size_t>(finding)];
  if (finding == Finding::Missed) out.missed.push_back(rate);
  if (finding == Finding::Unknown) out.unknown.push_back(rate);
}

std::array<double, 5> quartiles(std::vector<double> values) {
  std::array<double, 5> out{};
  if (values.empty()) return out;
  std::ranges::sort(values);
  for (std::size_t k = 0; k < out.size(); ++k) out[k] = values[k * (values.size() - 1) / (out.size() - 1)];
  return out;
}

// Why iterations miss; empty if they do not.
std::string why_missed(const RateVerdict& v, const RateRequirement& required) {
  if (v.missed.empty()) return {};
  double lowest = std::numeric_limits<double>::infinity();
  for (const auto& rate : v.missed) lowest = std::min(lowest, *rate.rate.order);
  if (lowest < required.least) return fmt::format("an order below {:.4g}", required.least);
  const bool few = static_cast<double>(v.reach()) < required.share * static_cast<double>(v.judged());
  return few && v.missed.size() > 1 ? fmt::format("fewer than {:.0f} % reach the order", 100 * required.share)
                                    : std::string();
}

// Why nothing can be said; empty if it can.
std::string why_unknown(const RateVerdict& v, const RateRequirement& required) {
  if (v.ends_in_failure) return "the iteration fails in the end, and its last attempts show no order";
  if (v.judged() == 0)
    return "no increment shows an order, all are over too soon; of a scene, which is solved until rounding, longer "
           "increments show it (fewer loading.steps)";
  if (2 * (v.judged() + v.of(Finding::UnitScale)) < v.increments - v.of(Finding::AtRounding))
    return "fewer than half of the increments can be judged; longer ones show more (fewer loading.steps)";
  if (static_cast<double>(v.reach()) < required.share * static_cast<double>(v.judged()))
    return fmt::format("one of {} increments misses the order by little, too few to tell", v.judged());
  return {};
}

}  // namespace

RateVerdict judge(const std::vector<IncrementRate>& rates, const RateRequirement& required) {
  RateVerdict out;
  std::vector<double> orders;
  for (const auto& rate : rates) {
    count(rate, required, out);
    const Finding finding = find(rate.rate, required);
    if (rate.failed || !(finding == Finding::Order || finding == Finding::Constant || finding == Finding::Missed))
      continue;
    if (rate.rate.order) orders.push_back(*rate.rate.order);
    if (rate.rate.least_ratio)
      out.sharpest = std::min(out.sharpest.value_or(*rate.rate.least_ratio), *rate.rate.least_ratio);
  }
  out.orders = quartiles(std::move(orders));
  if (out.reason = why_missed(out, required); !out.reason.empty())
    out.answer = RateAnswer::Misses;
  else if (out.reason = why_unknown(out, required); out.reason.empty())
    out.answer = RateAnswer::Holds;
  return out;
}

bool is_clearly_linear(const std::vector<IncrementRate>& rates, const RateRequirement& required) {
  std::size_t in_a_row = 0;
  for (const auto& rate : rates) {
    if (rate.failed) continue;
    const bool linear = find(rate.rate, required) == Finding::Missed && *rate.rate.order < required.least;
    in_a_row = linear ? in_a_row + 1 : 0;
    if (in_a_row >= kClearlyLinear) return true;
  }
  return false;
}

problem::Specification until_rounding(problem::Specification scene) {
  auto& solver = scene.solver;
  solver.min_iterations = std::max(solver.min_iterations, 4);
  solver.max_iterations = std::max(solver.max_iterations, solver.min_iterations + 8);
  solver.residual_tolerance = std::numeric_limits<double>::min();  // the level of rounding counts as zero
  return scene;
}

}  // namespace cleft::tangent_check
