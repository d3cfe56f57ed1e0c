#include "cleft/convergence/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <span>

#include "study_checks.hpp"
#include "study_costs.hpp"
#include "study_files.hpp"
#include "study_plan.hpp"
#include "study_runs.hpp"
#include "study_values.hpp"

namespace cleft::convergence {
namespace {

using scene::Quantity;

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
    if (runs[i].is_reference[quantity]) options.reference_h = out.reference_h = runs[i].h;
    if (!std::isfinite(runs[i].value[quantity])) continue;
    out.runs.push_back(i);
    h.push_back(runs[i].h);
    value.push_back(runs[i].value[quantity]);
  }
  const bool is_value = q.kind == Quantity::Kind::History;
  out.from_finest.assign(h.size(), kNotKnown);
  if (is_value && !value.empty()) out.from_finest = from_last(value);
  options.limit = is_value ? q.exact : std::optional(0.0);
  if (h.size() < 2) {
    out.fit.remark = "too few meshes";
    if (options.reference_h == 0.0) out.fit.limit = options.limit.value_or(kNotKnown);
  } else {
    out.fit = fit_limit(h, value, options);
  }
  out.has_errors = options.limit || out.fit.determined || out.fit.kind == SeriesClass::Exact;
  for (const double v : value) out.error.push_back(out.has_errors ? std::fabs(v - out.fit.limit) : kNotKnown);
  if (is_value && out.has_errors && std::isfinite(out.fit.limit) && out.fit.limit != 0.0)
    out.scale = std::fabs(out.fit.limit);
  return out;
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
    if (places > 1) std::ranges::move(costs_of(of_variant), std::back_inserter(result.costs));
  }
  for (const auto& run : result.runs)
    if (!run.failure.empty()) result.failed.push_back(title_of(run) + ": " + run.failure);
  for (std::size_t k = 0; k < study.quantities.size(); ++k)
    for (const auto& variant : study.variants) {
      result.series.push_back(series_of(study, k, result.runs, variant.label));
      check_series(study.quantities[k], result.series.back(), result);
      std::ranges::move(work_of(result, result.series.size() - 1), std::back_inserter(result.work));
    }
  write_study(study, result, options.directory);
  return result;
}

}  // namespace cleft::convergence
