/// \file
/// Figures of curves, drawn by gnuplot.
#pragma once

#include <string>
#include <vector>

namespace cleft::verify {

struct Curve {
  std::string title;
  std::vector<double> x, y;
  bool points = true;  ///< marks at the points
  bool lines = true;   ///< lines between them
};

struct Figure {
  std::string title, x_label, y_label;
  bool logarithmic = false;  ///< both axes
  std::vector<Curve> curves;
};

/// Writes NAME.gp, a script with its data, and has gnuplot draw NAME.svg from it. False if gnuplot is missing or fails;
/// the script is there all the same. Throws std::runtime_error if the script cannot be written.
bool draw(const Figure& figure, const std::string& directory, const std::string& name);

}  // namespace cleft::verify
