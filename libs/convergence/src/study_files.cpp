#include "study_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>

#include "cleft/support/files.hpp"
#include "study_figures.hpp"

namespace cleft::convergence {
namespace {

// A cell of a CSV row.
std::string cell(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? "\"\"" : std::string(1, c);
  return out + "\"";
}

std::set<std::string> phases_of(const std::vector<StudyRun>& runs) {
  std::set<std::string> out;
  for (const auto& run : runs)
    for (const auto& [phase, seconds] : run.phases) out.insert(phase);
  return out;
}

// A row per run: what varies, what came out, what it took.
std::string runs_csv(const scene::Study& study, const StudyResult& result) {
  std::string out;
  for (const auto* keys : {&study.sweep_keys, &study.sequence_keys})
    for (const auto& key : *keys) out += cell(key) + ",";
  for (const auto& q : study.quantities) out += cell(q.name) + ",";
  out += "h,unknowns,seconds,megabytes,increments,iterations,cuts,jobs,timings,seconds_spread,end,folder\n";
  for (std::size_t i = 0; i < result.runs.size(); ++i) {
    const auto& r = result.runs[i];
    const std::size_t places = study.sequence.size();
    for (const auto* setting : {&study.variants[i / places], &study.sequence[i % places]})
      for (const auto& value : setting->values) out += cell(value) + ",";
    for (const double value : r.value) fmt::format_to(std::back_inserter(out), "{},", value);
    fmt::format_to(std::back_inserter(out), "{},{},{},{},{},{},{},{},{},{},{},{}\n", r.h, r.unknowns, r.seconds,
                   r.megabytes, r.increments, r.iterations, r.cuts, r.jobs, r.timings, r.seconds_spread,
                   r.failure.empty() ? "done" : cell(r.failure), cell(r.folder));
  }
  return out;
}

std::string study_csv(const scene::Study& study, const StudyResult& result) {
  const auto phases = phases_of(result.runs);
  std::string out =
      "quantity,variant,mesh,h,unknowns,value,error,relative_error,seconds,megabytes,increments,iterations,cuts,";
  for (const auto& phase : phases) out += phase + "_seconds,";
  out += "folder,from_finest,jobs,timings,seconds_spread\n";
  for (const auto& s : result.series)
    for (std::size_t k = 0; k < s.runs.size(); ++k) {
      const auto& r = result.runs[s.runs[k]];
      fmt::format_to(std::back_inserter(out), "{},{},{},{},{},{},{},{},{},{},{},{},{},",
                     cell(study.quantities[s.quantity].name), cell(s.variant), cell(r.mesh), r.h, r.unknowns,
                     r.value[s.quantity], s.error[k], s.error[k] / s.scale, r.seconds, r.megabytes, r.increments,
                     r.iterations, r.cuts);
      for (const auto& phase : phases) {
        const auto at = r.phases.find(phase);
        out += (at == r.phases.end() ? "nan" : fmt::format("{}", at->second)) + ",";
      }
      fmt::format_to(std::back_inserter(out), "{},{},{},{},{}\n", cell(r.folder), s.from_finest[k], r.jobs, r.timings,
                     r.seconds_spread);
    }
  return out;
}

std::string fits_csv(const scene::Study& study, const StudyResult& result) {
  std::string out =
      "quantity,variant,limit,limit_pm,order,order_pm,factor,scatter,determined,remark,class,observed_orders,"
      "asymptotic_ratio,window,finest,finest_pm,safety\n";
  for (const auto& s : result.series) {
    const LimitFit& fit = s.fit;
    const double limit = s.has_errors ? fit.limit : kNotKnown;
    const double finest = s.runs.empty() ? kNotKnown : result.runs[s.runs.back()].value[s.quantity];
    fmt::format_to(std::back_inserter(out), "{},{},{},{},{},{},{},{},{},{},{},{:.3f},{},{},{},{},{}\n",
                   cell(study.quantities[s.quantity].name), cell(s.variant), limit, fit.limit_pm, fit.order,
                   fit.order_pm, fit.factor, fit.scatter, fit.determined ? "yes" : "no", cell(fit.remark),
                   name_of(fit.kind), fmt::join(fit.observed_order, " "), fit.asymptotic_ratio, fit.window, finest,
                   fit.finest_pm, fit.safety);
  }
  return out;
}

std::string costs_csv(const StudyResult& result) {
  std::string out = "cost,variant,exponent,exponent_pm,factor,determined,remark,last_slope,over\n";
  for (const auto& c : result.costs)
    fmt::format_to(std::back_inserter(out), "{},{},{},{},{},{},{},{},{}\n", c.what, cell(c.variant), c.fit.order,
                   c.fit.order_pm, c.fit.factor, c.fit.determined ? "yes" : "no", cell(c.fit.remark), c.last_slope,
                   c.over);
  return out;
}

std::string work_csv(const scene::Study& study, const StudyResult& result) {
  std::string out = "quantity,variant,relative_error,seconds,how\n";
  for (const auto& w : result.work) {
    const Series& s = result.series[w.series];
    fmt::format_to(std::back_inserter(out), "{},{},{},{},{}\n", cell(study.quantities[s.quantity].name),
                   cell(s.variant), w.error, w.seconds, name_of(w.how));
  }
  return out;
}

}  // namespace

void write_study(const scene::Study& study, const StudyResult& result, const std::string& directory) {
  write_atomically(directory + "/runs.csv", runs_csv(study, result));
  write_atomically(directory + "/study.csv", study_csv(study, result));
  write_atomically(directory + "/fits.csv", fits_csv(study, result));
  write_atomically(directory + "/costs.csv", costs_csv(result));
  write_atomically(directory + "/work.csv", work_csv(study, result));
  if (study.sequence.size() > 1) draw_study(study, result, directory);
}

}  // namespace cleft::convergence
