// The figures of a report. Each function leaves out those for which the runs have no data.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cleft/plot/figure.hpp"
#include "run_data.hpp"

namespace cleft::report {

/// A figure and what the page says below it.
struct PageFigure {
  plot::Drawing drawing;
  std::string caption;
};
using PageFigures = std::vector<PageFigure>;

/// Reactions over the load and over prescribed displacements.
PageFigures reaction_figures(const std::vector<Run>& runs);
/// Energies, contact, plastic strain, stress intensities and growth over the load.
PageFigures history_figures(const std::vector<Run>& runs);
/// What acts along every crack at the outputs.
PageFigures profile_figures(const std::vector<Run>& runs);
/// Residuals, increments and iterations, seconds by phase.
PageFigures solver_figures(const std::vector<Run>& runs);

/// The deformed mesh of one output. `prefix` begins the name of the drawing.
plot::Drawing mesh_drawing(const Run& run, const Shape& shape, std::size_t field, const std::string& prefix);

/// Seconds by phase of a run that has ended, the rest of the total last.
std::vector<std::pair<std::string, double>> phases_of(const Run& run);

/// "label: text" where there are several runs, else the text.
std::string with_label(const std::vector<Run>& runs, std::size_t run, const std::string& text);

/// A curve `k` of run `r`: dashes tell the curves of a run apart, and colours those of a single run or several runs.
plot::Curve curve_of(const std::vector<Run>& runs, std::size_t r, std::size_t k, const std::string& title);

/// A figure without a unit in its y label yet, whose curves hold SI numbers.
struct Sketch {
  std::string name, title, x_label, y_label, y_unit;
  std::string caption;
  plot::Scale scale = plot::Scale::Linear;
  std::vector<plot::Curve> curves;
};
/// Gives it the unit that keeps its numbers readable and adds it to the figures, unless no curve has a point.
void add(PageFigures& figures, Sketch sketch);

}  // namespace cleft::report
