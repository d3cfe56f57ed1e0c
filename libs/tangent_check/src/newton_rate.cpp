#include "cleft/tangent_check/newton_rate.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>

#include "cleft/support/files.hpp"

namespace cleft::tangent_check {
namespace {

using solve::Iteration, solve::LargestResidual;

// A step that gains less is still on its way: what follows would show any order.
constexpr double kLeastGain = 2.0;

// A step that leaves so little of a correction shows no error of the tangent.
constexpr double kLinear = 1e-6;

// g+/g^2 of what the strains' nonlinearity leaves out is of order one; on yielding bodies it is larger, and only its
// growth tells. A linear iteration that is told from a quadratic one by growth has to have let it grow much more.
constexpr double kUnitConstant = 10.0, kGrowth = 10.0, kFall = 0.1;

// Times rounding: from a residual so small the first step already ends there.
constexpr double kNearRounding = 1e4;

constexpr std::size_t kStalls =
    5;  // so many corrections, of which the last ones hardly fall, have no better order than 1

bool near_rounding(const Iteration& it) { return it.residual <= kNearRounding * it.rounding; }

using Size = double (*)(const Iteration&);
constexpr std::array<Size, 4> kSizes{
    [](const Iteration& it) { return it.gradient; }, [](const Iteration& it) { return it.correction; },
    [](const Iteration& it) { return std::sqrt(it.energy); }, [](const Iteration& it) { return it.residual; }};

// The highest order of three consecutive iterations.
std::optional<double> order_of(const Iteration& a, const Iteration& b, const Iteration& c) {
  std::optional<double> out;
  for (const Size size : kSizes) {
    const double gained = std::log(size(a) / size(b));
    if (!(gained >= std::log(kLeastGain)) || !(size(b) > 0.0 && size(c) > 0.0)) continue;
    out = std::max(out, std::optional(std::log(size(b) / size(c)) / gained));
  }
  return out;
}

// What is left of a correction by the next one, of the last iteration of an increment by its residual.
double left_of(const Iteration& now, const Iteration& next) {
  return next.gradient > 0.0 ? next.gradient / now.gradient : next.residual / now.residual;
}

void observe_steps(const solve::SettledCorrections& settled, ObservedRate& out) {
  const auto& [its, clear, next] = settled;
  const auto keep_least = [&](double ratio) {
    if (std::isfinite(ratio)) out.least_ratio = std::min(out.least_ratio.value_or(ratio), ratio);
  };
  if (next) keep_least(left_of(its[clear - 1], *next));
  if (clear > 1) keep_least(left_of(its[clear - 2], its[clear - 1]));
  if (clear < 3) return;
  out.constants.emplace();
  out.ratios.emplace();
  for (std::size_t k = 0; k < 2; ++k) {
    const double g = its[clear - 3 + k].gradient;
    (*out.ratios)[k] = its[clear - 2 + k].gradient / g;
    (*out.constants)[k] = (*out.ratios)[k] / g;
  }
}

// Far above rounding, where corrections that fall at all fall faster and faster.
bool stalls(std::span<const Iteration> its) {
  while (!its.empty() && near_rounding(its.back())) its = its.first(its.size() - 1);
  return its.size() >= kStalls && kLeastGain * its.back().gradient >= its[its.size() - 2].gradient;
}

bool is_bounded(const ObservedRate& rate) {
  if (!rate.constants || !(rate.ratios->back() <= kFall * rate.ratios->front())) return false;
  return rate.constants->back() <= std::max(kUnitConstant, kGrowth * rate.constants->front());
}

}  // namespace

ObservedRate observe(const std::vector<Iteration>& iterations) {
  const auto settled = solve::settled_corrections(iterations);
  const auto& [its, clear, next] = settled;
  ObservedRate out;
  out.corrections = clear;
  out.at_unit_scale = solve::order_at_unit_scale(iterations);
  const bool still = std::ranges::none_of(iterations, &Iteration::switches);
  out.starts_at_rounding = still && (clear == 0 || (clear < 3 && near_rounding(its.front())));
  if (clear == 0) return out;
  observe_steps(settled, out);
  if (clear >= 3) out.order = order_of(its[clear - 3], its[clear - 2], its[clear - 1]);
  if (!out.order && stalls(its.first(clear))) out.order = 1.0;
  if (clear < 2 || !next || its[clear - 1].kept) return out;
  const auto bound = order_of(its[clear - 2], its[clear - 1], *next);
  out.is_bound = clear < 3 && bound;
  out.order = std::max(out.order, bound);
  return out;
}

Finding find(const ObservedRate& rate, const RateRequirement& required) {
  if (rate.order && *rate.order >= required.order) return Finding::Order;
  if (rate.least_ratio && *rate.least_ratio <= kLinear) return Finding::Linear;
  if (required.order <= 2.0 && is_bounded(rate)) return Finding::Constant;
  if (rate.corrections >= 3 && rate.order) return Finding::Missed;
  if (rate.starts_at_rounding) return Finding::AtRounding;
  return rate.at_unit_scale && *rate.at_unit_scale >= required.order ? Finding::UnitScale : Finding::Unknown;
}

namespace {

// newton.csv, column by column.
class Rows {
 public:
  explicit Rows(const std::string& path) : path_(path), table_(read_csv(path)) {
    const auto at = std::ranges::find(table_.header, "largest");
    largest_ = static_cast<std::size_t>(at - table_.header.begin());
  }

  std::size_t size() const { return table_.rows.size(); }
  std::vector<double> operator()(const char* name) const {
    try {
      return table_.column(name);
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(path_ + ": " + error.what());
    }
  }
  LargestResidual::At largest(std::size_t row) const {
    for (const auto& each : names_of(LargestResidual::At{}))
      if (largest_ < table_.rows[row].size() && table_.rows[row][largest_] == each.name) return each.value;
    return LargestResidual::At::Nowhere;
  }

 private:
  std::string path_;
  CsvTable table_;
  std::size_t largest_;
};

std::vector<Iteration> iterations_of(const Rows& rows) {
  const auto residual = rows("residual"), rounding = rows("rounding"), correction = rows("correction"),
             gradient = rows("gradient"), energy = rows("energy"), partner = rows("partner_changes"),
             status = rows("status_changes"), flow = rows("flow_changes"), cycles = rows("chatters"),
             kept = rows("kept"), x = rows("largest_X"), y = rows("largest_Y");
  std::vector<Iteration> out(rows.size());
  for (std::size_t k = 0; k < out.size(); ++k) {
    Iteration& it = out[k];
    it.residual = residual[k];
    it.rounding = rounding[k];
    it.correction = correction[k];
    it.gradient = gradient[k];
    it.energy = energy[k];
    it.partner_changes = static_cast<int>(partner[k]);
    it.status_changes = static_cast<int>(status[k]);
    it.flow_changes = static_cast<int>(flow[k]);
    it.cycles = cycles[k] != 0.0;
    it.kept = kept[k] != 0.0;
    it.largest = {rows.largest(k), {x[k], y[k]}};
  }
  return out;
}

}  // namespace

std::vector<IncrementRate> newton_rates(const std::string& directory) {
  const Rows rows(directory + "/newton.csv");
  const auto step = rows("step"), load = rows("load"), number = rows("iteration"), failed = rows("failed");
  const auto iterations = iterations_of(rows);
  std::vector<IncrementRate> rates;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (rates.empty() || number[k] == 1.0)
      rates.push_back({static_cast<int>(step[k]), load[k], failed[k] != 0.0, {}, {}});
    rates.back().iterations.push_back(iterations[k]);
  }
  for (auto& rate : rates) rate.rate = observe(rate.iterations);
  return rates;
}

}  // namespace cleft::tangent_check
