#include "study_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "cleft/plot/figure.hpp"

namespace cleft::convergence {
namespace {

enum class Over { Size, Seconds };

constexpr int kColoursInAll = 7;    // of plot::colour; curves beyond them differ in their marks
constexpr std::size_t kSteps = 24;  // of a fitted line

std::string title_of(const scene::Study& study, const Series& s) {
  return study.quantities[s.quantity].name + (s.variant.empty() ? "" : ", " + s.variant);
}

// Distances from the finest mesh are not errors.
bool shows_errors(const Series& s) { return s.has_errors && s.reference_h == 0.0; }

bool has_line(const Series& s) { return s.has_errors && s.fit.determined && s.fit.window > 1; }

// What the results of a series are, over h or over seconds: marks, joined where no fitted line is drawn.
plot::Curve marks_of(const scene::Study& study, const StudyResult& result, const Series& s, Over over) {
  const bool cost = over == Over::Seconds;
  plot::Curve c;
  c.title = title_of(study, s);
  c.lines = cost || !has_line(s);
  for (std::size_t k = 0; k < s.runs.size(); ++k) {
    const StudyRun& run = result.runs[s.runs[k]];
    if (cost && !run.failure.empty()) continue;  // its seconds are not those of a whole run
    c.x.push_back(cost ? run.seconds : run.h);
    c.y.push_back(s.has_errors ? s.error[k] / s.scale : s.from_finest[k]);
  }
  return c;
}

// The fitted power over the meshes that it is fitted to.
plot::Curve line_of(const StudyResult& result, const Series& s) {
  plot::Curve c;
  c.points = false;
  const double coarse = result.runs[s.runs[s.runs.size() - s.fit.window]].h, fine = result.runs[s.runs.back()].h;
  for (std::size_t k = 0; k <= kSteps; ++k) {
    const double h = fine * std::pow(coarse / fine, static_cast<double>(k) / kSteps);
    const double power = std::pow(h, s.fit.order) - (s.reference_h > 0.0 ? std::pow(s.reference_h, s.fit.order) : 0.0);
    c.x.push_back(h);
    c.y.push_back(std::fabs(s.fit.factor) * power / s.scale);
  }
  return c;
}

// Orders that are determined, to the nearest half: at most three, for which a triangle is drawn.
std::vector<double> slopes_of(const StudyResult& result) {
  std::set<double> out;
  for (const auto& s : result.series)
    if (has_line(s) && s.fit.order > 0.25) out.insert(0.5 * std::round(2.0 * s.fit.order));
  while (out.size() > 3) out.erase(std::next(out.begin()));
  return {out.begin(), out.end()};
}

// Triangles of these slopes below the curves, with one corner in common.
void add_triangles(const std::vector<double>& slopes, plot::Figure& f) {
  double left = INFINITY, right = 0.0, low = INFINITY;
  for (const auto& c : f.curves)
    for (std::size_t k = 0; k < c.x.size(); ++k) {
      if (!(c.x[k] > 0.0 && c.y[k] > 0.0)) continue;
      left = std::min(left, c.x[k]);
      right = std::max(right, c.x[k]);
      low = std::min(low, c.y[k]);
    }
  if (slopes.empty() || !(left < right)) return;
  const double from = left * std::pow(right / left, 0.55), to = left * std::pow(right / left, 0.8);
  for (const double slope : slopes) {
    const double top = low * std::pow(to / from, slope);
    plot::Curve c;
    c.points = false;
    c.colour = kColoursInAll - 1;  // black
    c.x = {from, to, to, from};
    c.y = {low, low, top, low};
    f.curves.push_back(c);
    f.notes.push_back({to, top, fmt::format("{}", slope)});
  }
}

plot::Figure figure_of(const scene::Study& study, const StudyResult& result, Over over) {
  const bool cost = over == Over::Seconds;
  plot::Figure f;
  f.title = study.title;
  f.x_label = cost ? "seconds" : study.size_label;
  const bool any = std::ranges::any_of(result.series, shows_errors);
  f.y_label = any ? "relative error" : "relative difference from the finest mesh";
  f.scale = plot::Scale::LogLog;
  for (std::size_t k = 0; k < result.series.size(); ++k) {
    const Series& s = result.series[k];
    const auto add = [&](plot::Curve c) {
      c.colour = static_cast<int>(k) % kColoursInAll;
      c.dash = static_cast<int>(k) / kColoursInAll;
      f.curves.push_back(std::move(c));
    };
    plot::Curve marks = marks_of(study, result, s, over);
    if (any && !shows_errors(s)) marks.title += ", from finest";
    if (!cost && has_line(s)) marks.title += fmt::format(", order {:.2f}", s.fit.order);
    add(std::move(marks));
    if (!cost && has_line(s)) add(line_of(result, s));
  }
  if (!cost) add_triangles(slopes_of(result), f);
  return f;
}

}  // namespace

void draw_study(const scene::Study& study, const StudyResult& result, const std::string& directory) {
  plot::draw({drawing_of(figure_of(study, result, Over::Size), "convergence"),
              drawing_of(figure_of(study, result, Over::Seconds), "cost")},
             directory, "cleft converge");
}

}  // namespace cleft::convergence
