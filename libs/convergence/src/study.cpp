#include "cleft/convergence/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <span>

#include "study_files.hpp"
#include "study_plan.hpp"
#include "study_runs.hpp"
#include "study_values.hpp"

namespace cleft::convergence {
namespace {

using scene::Quantity;

constexpr double kUndetermined = std::numeric_limits<double>::quiet_NaN();

// Differences from the last value over its size, or absolute where that is 0.
std::vector<double> from_last(const std::vector<double>& value) {
  const double scale = value.back() != 0.0 ? std::fabs(value.back()) : 1.0;
  std::vector<double> out;
  for (const double v : value) out.push_back(std::fabs(v - value.back()) / scale);
  return out;
}

Series series_of(const scene::Study& study, std::size_t quantity, const std::vector<StudyRun>& runs,
                 const std::string& variant) {
  const Quantity& q = study.quantities[quantity];
  Series out;
  out.quantity = quantity;
  out.variant = variant;
  std::vector<double> h, value;
  FitOptions options;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (runs[i].variant != variant) continue;
    if (runs[i].is_reference[quantity]) options.reference_h = runs[i].h;
    if (!std::isfinite(runs[i].value[quantity])) continue;
    out.runs.push_back(i);
    h.push_back(runs[i].h);
    value.push_back(runs[i].value[quantity]);
  }
  const bool is_value = q.kind == Quantity::Kind::History;
  out.from_finest.assign(h.size(), kUndetermined);
  if (is_value && !value.empty()) out.from_finest = from_last(value);
  options.limit = is_value ? q.exact : std::optional(0.0);
  if (h.size() < 2) {
    out.fit.remark = "too few meshes";
    out.fit.limit = out.fit.order = kUndetermined;
  } else {
    out.fit = fit_limit(h, value, options);
  }
  out.has_errors = options.limit || out.fit.determined;
  for (const double v : value) out.error.push_back(out.has_errors ? std::fabs(v - out.fit.limit) : kUndetermined);
  if (is_value && out.has_errors && std::isfinite(out.fit.limit) && out.fit.limit != 0.0)
    out.scale = std::fabs(out.fit.limit);
  return out;
}

// Of the runs of one variant that reached their end.
class CostFits {
 public:
  explicit CostFits(std::span<const StudyRun> runs) {
    for (const auto& run : runs)
      if (run.failure.empty()) runs_.push_back(&run);
    const auto other = [&](const StudyRun* run) { return run->unknowns != runs_[0]->unknowns; };
    over_unknowns_ = runs_.size() < 2 || std::ranges::any_of(runs_, other);
  }

  std::vector<Cost> all() {
    add("seconds", [](const StudyRun& run) { return run.seconds; });
    add("megabytes", [](const StudyRun& run) { return run.megabytes; });
    add("iterations", [](const StudyRun& run) { return static_cast<double>(run.iterations); });
    std::set<std::string> phases;
    for (const auto* run : runs_)
      for (const auto& [phase, seconds] : run->phases) phases.insert(phase);
    for (const auto& phase : phases)
      add(phase + "_seconds", [&](const StudyRun& run) {
        const auto at = run.phases.find(phase);
        return at == run.phases.end() ? kUndetermined : at->second;
      });
    return std::move(out_);
  }

 private:
  template <class Of>
  void add(const std::string& what, const Of& of) {
    std::vector<double> size, cost;
    for (const auto* run : runs_) {
      if (const double value = of(*run); std::isfinite(value)) {
        cost.push_back(value);
        size.push_back(over_unknowns_ ? static_cast<double>(run->unknowns) : 1.0 / run->h);
      }
    }
    if (cost.empty()) return;
    out_.push_back(
        {runs_[0]->variant, what, fit_power(size, cost), over_unknowns_ ? "unknowns" : "1/h", last_slope(size, cost)});
  }
  static double last_slope(const std::vector<double>& size, const std::vector<double>& cost) {
    const std::size_t n = cost.size();
    if (n < 2 || !(cost[n - 1] > 0.0 && cost[n - 2] > 0.0) || size[n - 1] == size[n - 2]) return kUndetermined;
    return std::log(cost[n - 1] / cost[n - 2]) / std::log(size[n - 1] / size[n - 2]);
  }

  std::vector<const StudyRun*> runs_;
  bool over_unknowns_ = false;
  std::vector<Cost> out_;
};

void check_series(const Quantity& q, const Series& s, std::vector<std::string>& missed) {
  const std::string name = q.name + (s.variant.empty() ? "" : ", " + s.variant);
  const auto check = [&](const char* what, double value, const auto& within) {
    if (within && !(value >= (*within)[0] && value <= (*within)[1]))
      missed.push_back(
          fmt::format("{}: {} {:.4g} is not within [{}, {}]", name, what, value, (*within)[0], (*within)[1]));
  };
  if (s.has_errors) {
    check("order", s.fit.order, q.order_within);
    check("limit", s.fit.limit, q.limit_within);
  } else if (q.order_within || q.limit_within)
    missed.push_back(fmt::format("{}: no limit is determined: {}", name, s.fit.remark));
}

}  // namespace

StudyResult run_study(const scene::Study& study, const StudyOptions& options) {
  Plan plan = plan_of(study, options);
  std::filesystem::create_directories(options.directory + "/runs");
  run_all(study, options, plan);
  StudyResult result;
  result.runs = std::move(plan.runs);
  const std::size_t places = study.sequence.size();
  for (std::size_t first = 0; first < result.runs.size(); first += places) {
    const auto of_variant = std::span(result.runs).subspan(first, places);
    read_values(study, of_variant);
    if (places > 1) std::ranges::move(CostFits(of_variant).all(), std::back_inserter(result.costs));
  }
  for (const auto& run : result.runs)
    if (!run.failure.empty()) result.failed.push_back(title_of(run) + ": " + run.failure);
  for (std::size_t k = 0; k < study.quantities.size(); ++k)
    for (const auto& variant : study.variants) {
      result.series.push_back(series_of(study, k, result.runs, variant.label));
      check_series(study.quantities[k], result.series.back(), result.missed);
    }
  write_study(study, result, options.directory);
  return result;
}

}  // namespace cleft::convergence
