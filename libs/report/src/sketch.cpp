#include <algorithm>

#include "figures.hpp"
#include "unit.hpp"

namespace cleft::report {

std::string with_label(const std::vector<Run>& runs, std::size_t run, const std::string& text) {
  if (runs.size() == 1) return text;
  return text.empty() ? runs[run].label : runs[run].label + ": " + text;
}

plot::Curve curve_of(const std::vector<Run>& runs, std::size_t r, std::size_t k, const std::string& title) {
  constexpr std::size_t kMarks = 60;  // more of them would hide the line
  plot::Curve c;
  c.title = with_label(runs, r, title);
  c.colour = static_cast<int>(runs.size() == 1 ? k : r);
  c.dash = static_cast<int>(k);
  c.points = runs[r].history.rows.size() <= kMarks;
  return c;
}

void add(PageFigures& figures, Sketch sketch) {
  double largest = 0.0;
  for (const auto& c : sketch.curves) largest = std::max(largest, largest_of(c.y));
  const bool empty = std::ranges::all_of(sketch.curves, [](const plot::Curve& c) { return c.x.empty(); });
  if (empty) return;
  const Unit unit = sketch.scale == plot::Scale::Linear ? unit_for(largest, sketch.y_unit) : Unit{1.0, sketch.y_unit};
  for (auto& c : sketch.curves)
    for (double& y : c.y) y *= unit.scale;
  plot::Figure f;
  f.title = sketch.title;
  f.x_label = sketch.x_label;
  f.y_label = unit.label(sketch.y_label);
  f.scale = sketch.scale;
  f.curves = std::move(sketch.curves);
  figures.push_back({plot::drawing_of(f, sketch.name), sketch.caption});
}

}  // namespace cleft::report
