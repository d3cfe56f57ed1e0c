#include "study_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "cleft/plot/figure.hpp"
#include "cleft/support/files.hpp"

namespace cleft::convergence {
namespace {

// A cell of a CSV row.
std::string cell(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? "\"\"" : std::string(1, c);
  return out + "\"";
}

std::string runs_csv(const scene::Study& study, const StudyResult& result) {
  std::string out =
      "quantity,variant,mesh,h,unknowns,value,error,relative_error,seconds,megabytes,increments,iterations,cuts,";
  for (const auto& [phase, seconds] : result.runs.at(0).phases) out += phase + "_seconds,";
  out += "folder,from_finest\n";
  for (const auto& s : result.series)
    for (std::size_t k = 0; k < s.runs.size(); ++k) {
      const auto& r = result.runs[s.runs[k]];
      fmt::format_to(std::back_inserter(out), "{},{},{},{},{},{},{},{},{},{},{},{},{},",
                     cell(study.quantities[s.quantity].name), cell(s.variant), r.mesh, r.h, r.unknowns,
                     r.value[s.quantity], s.error[k], s.error[k] / s.scale, r.seconds, r.megabytes, r.increments,
                     r.iterations, r.cuts);
      for (const auto& [phase, seconds] : r.phases) fmt::format_to(std::back_inserter(out), "{},", seconds);
      out += fmt::format("{},{}\n", cell(r.folder), s.from_finest[k]);
    }
  return out;
}

std::string fits_csv(const scene::Study& study, const StudyResult& result) {
  std::string out =
      "quantity,variant,limit,limit_pm,order,order_pm,factor,scatter,determined,remark,class,observed_orders,"
      "asymptotic_ratio,window,finest,finest_pm,safety\n";
  for (const auto& s : result.series) {
    const LimitFit& fit = s.fit;
    const double limit = s.has_errors || fit.kind == SeriesClass::Exact ? fit.limit : kNotKnown;
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
  std::string out = "cost,variant,exponent,exponent_pm,factor,determined,remark\n";
  for (const auto& c : result.costs)
    fmt::format_to(std::back_inserter(out), "{},{},{},{},{},{},{}\n", c.what, cell(c.variant), c.fit.order,
                   c.fit.order_pm, c.fit.factor, c.fit.determined ? "yes" : "no", cell(c.fit.remark));
  return out;
}

plot::Figure figure_of(const scene::Study& study, const StudyResult& result, bool cost) {
  plot::Figure f;
  f.title = study.title;
  f.x_label = cost ? "seconds" : "h, m";
  const bool any = std::ranges::any_of(result.series, &Series::has_errors);
  f.y_label = any ? "relative error" : "relative difference from the finest mesh";
  f.scale = plot::Scale::LogLog;
  for (const auto& s : result.series) {
    plot::Curve c;
    c.title = study.quantities[s.quantity].name + (s.variant.empty() ? "" : ", " + s.variant);
    if (any && !s.has_errors) c.title += ", from finest";
    for (std::size_t k = 0; k < s.runs.size(); ++k) {
      c.x.push_back(cost ? result.runs[s.runs[k]].seconds : result.runs[s.runs[k]].h);
      c.y.push_back(s.has_errors ? s.error[k] / s.scale : s.from_finest[k]);
    }
    f.curves.push_back(c);
  }
  return f;
}

}  // namespace

void write_study(const scene::Study& study, const StudyResult& result, const std::string& directory) {
  write_atomically(directory + "/study.csv", runs_csv(study, result));
  write_atomically(directory + "/fits.csv", fits_csv(study, result));
  write_atomically(directory + "/costs.csv", costs_csv(result));
  plot::draw(
      {drawing_of(figure_of(study, result, false), "convergence"), drawing_of(figure_of(study, result, true), "cost")},
      directory, "cleft converge");
}

}  // namespace cleft::convergence
