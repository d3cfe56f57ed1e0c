#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>

#include "figures.hpp"
#include "unit.hpp"

namespace cleft::report {
namespace {

constexpr double kGap = std::numeric_limits<double>::quiet_NaN();  // parts a line

// One line an increment: of one run coloured by load, of several by run.
void add_residuals(PageFigures& figures, const std::vector<Run>& runs) {
  plot::Figure f;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    if (!runs[r].newton || runs[r].newton->rows.empty()) continue;
    const std::string path = runs[r].directory + "/newton.csv";
    const auto& table = *runs[r].newton;
    const auto load = column_of(table, "load", path), iteration = column_of(table, "iteration", path),
               residual = column_of(table, "residual", path);
    plot::Curve c = curve_of(runs, r, 0, "");
    c.dash = 0;
    c.points = true;
    for (std::size_t k = 0; k < load.size(); ++k) {
      if (k > 0 && iteration[k] <= iteration[k - 1]) {
        c.x.push_back(kGap);
        c.y.push_back(kGap);
        c.shade.push_back(kGap);
      }
      c.x.push_back(iteration[k]);
      c.y.push_back(residual[k]);
      c.shade.push_back(load[k]);
    }
    if (runs.size() > 1) c.shade.clear();
    f.curves.push_back(std::move(c));
  }
  if (f.curves.empty()) return;
  f.title = "Newton's iteration";
  f.x_label = "evaluation of the residual in its increment";
  f.y_label = "residual, relative to the scale of forces";
  f.scale = plot::Scale::LogY;
  if (runs.size() == 1) f.shade_label = "load";
  figures.push_back({plot::drawing_of(f, "newton"),
                     "A line an attempt at an increment; quadratic convergence doubles the digits at each step."});
}

void add_increments(PageFigures& figures, const std::vector<Run>& runs) {
  Sketch size, work;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const auto load = runs[r].column("load"), iterations = runs[r].column("iterations"), cuts = runs[r].column("cuts");
    plot::Curve c = curve_of(runs, r, 0, "");
    c.dash = 0;
    c.x = load;
    for (std::size_t k = 0; k < load.size(); ++k) c.y.push_back(k > 0 ? load[k] - load[k - 1] : load[k]);
    size.curves.push_back(c);
    c.title = with_label(runs, r, "iterations");
    c.y = iterations;
    work.curves.push_back(c);
    if (largest_of(cuts) == 0.0) continue;
    c = curve_of(runs, r, 1, "cuts of the increment");
    c.x = load;
    c.y = cuts;
    work.curves.push_back(std::move(c));
  }
  size.name = "increments";
  size.title = "Increments of the load";
  size.x_label = work.x_label = "load";
  size.y_label = "increment of the load";
  size.caption = "Below 0 where the path of equilibria goes back.";
  work.name = "iterations";
  work.title = "Iterations and cuts of each increment";
  work.y_label = "number";
  add(figures, std::move(size));
  add(figures, std::move(work));
}

void add_phases(PageFigures& figures, const std::vector<Run>& runs) {
  std::vector<std::vector<std::pair<std::string, double>>> columns;
  std::vector<std::string> titles;
  for (std::size_t r = 0; r < runs.size(); ++r)
    if (auto phases = phases_of(runs[r]); !phases.empty()) {
      columns.push_back(std::move(phases));
      titles.push_back(runs[r].label);
    }
  if (columns.empty()) return;
  std::string s =
      "set title 'Time by phase'\nset ylabel 'seconds'\nset yrange [0:*]\nset grid ytics lc rgb '#cccccc'\n"
      "set style data histogram\nset style histogram clustered gap 1\nset style fill solid noborder\n"
      "set xtics rotate by -35 nomirror\nset key outside bottom center horizontal samplen 2\n$phases << EOD\n";
  for (std::size_t k = 0; k < columns[0].size(); ++k) {
    s += '"' + columns[0][k].first + '"';
    for (const auto& phases : columns)
      fmt::format_to(std::back_inserter(s), " {}", k < phases.size() ? phases[k].second : 0.0);
    s += '\n';
  }
  s += "EOD\nplot ";
  for (std::size_t k = 0; k < columns.size(); ++k)
    s += fmt::format("{}$phases using {}{} lc rgb '{}' {}", k > 0 ? ", " : "", k + 2, k == 0 ? ":xtic(1)" : "",
                     plot::colour(k), columns.size() > 1 ? "title " + plot::in_quotes(titles[k]) : "notitle");
  figures.push_back(
      {{"phases", s + "\n"}, "Other: the rest of the total; for a resumed run also what its earlier parts took."});
}

}  // namespace

std::vector<std::pair<std::string, double>> phases_of(const Run& run) {
  std::vector<std::pair<std::string, double>> phases;
  if (!run.info.is_object() || !run.info.contains("seconds")) return phases;
  double total = 0.0, sum = 0.0;
  for (const auto& [name, value] : run.info["seconds"].items()) {
    const double seconds = value.get<double>();
    if (name == "total") {
      total = seconds;
      continue;
    }
    phases.emplace_back(name, seconds);
    sum += seconds;
  }
  phases.emplace_back("other", std::max(0.0, total - sum));
  return phases;
}

PageFigures solver_figures(const std::vector<Run>& runs) {
  PageFigures figures;
  add_residuals(figures, runs);
  add_increments(figures, runs);
  add_phases(figures, runs);
  return figures;
}

}  // namespace cleft::report
