/// \file
/// Figures drawn by gnuplot, as SVG and as PNG.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace cleft::plot {

/// A line through points. A value that is not finite, or not positive on a logarithmic axis, parts the line.
struct Curve {
  std::string title;  ///< empty: not in the legend
  std::vector<double> x, y;
  bool points = true;         ///< marks at the points
  bool lines = true;          ///< lines between them
  int colour = -1;            ///< number of a colour; below 0: that of the curve's own number
  int dash = 0;               ///< number of a dash type, of which 0 is solid
  std::vector<double> shade;  ///< a value a point that colours it along the colour bar; empty: none
};

/// A word in the plot, to the right of its place.
struct Note {
  double x = 0.0, y = 0.0;
  std::string text;
};

enum class Scale { Linear, LogY, LogLog };

struct Figure {
  std::string title, x_label, y_label;
  std::string shade_label;  ///< of the colour bar, where a curve has shades
  Scale scale = Scale::Linear;
  std::vector<Curve> curves;
  std::vector<Note> notes;
};

/// What gnuplot is to draw: commands that end with the one that plots.
struct Drawing {
  std::string name;  ///< of its files, without their endings
  std::string script;
  int width = 520, height = 420;  ///< pixels; PNG has twice as many
};

Drawing drawing_of(const Figure& figure, const std::string& name);

/// The colour of a curve's number, as `#rrggbb`.
std::string colour(std::size_t number);
/// Text in single quotes, in which gnuplot interprets nothing.
std::string in_quotes(const std::string& text);
/// Commands for the colours of the colour bar, from low to high.
std::string palette_commands();
/// These colours as `#rrggbb`, evenly spaced.
const std::vector<std::string>& palette();

/// Writes NAME.gp, a script with its data whose first line names its `origin`, for each drawing, and has gnuplot draw
/// NAME.svg and NAME.png from it. Tells why if gnuplot is missing or fails; the scripts are there all the same.
/// Throws std::runtime_error if a script cannot be written.
std::optional<std::string> draw(const std::vector<Drawing>& drawings, const std::string& directory,
                                const std::string& origin);

/// Removes the scripts of that origin and what was drawn from them. Whatever else lies in the folder stays.
void remove_drawings(const std::string& directory, const std::string& origin);

}  // namespace cleft::plot
