#include "cleft/plot/figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "cleft/support/files.hpp"
#include "cleft/support/process.hpp"

namespace cleft::plot {
namespace {

// After Okabe and Ito, whom readers of any colour vision can tell apart; without their yellow, which is faint on white.
constexpr std::array kColours{"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000"};

constexpr const char* kNothing = "set xrange [0:1]\nset yrange [0:1]\nunset logscale\nplot NaN title 'no data'";

bool usable(double x, double y, Scale scale) {
  return std::isfinite(x) && std::isfinite(y) && (scale == Scale::Linear || y > 0.0) &&
         (scale != Scale::LogLog || x > 0.0);
}

// The rows of a curve. How many points they hold.
std::size_t add_rows(std::string& script, const Curve& c, Scale scale) {
  std::size_t drawn = 0;
  bool parted = true;
  for (std::size_t i = 0; i < c.x.size(); ++i) {
    if (!usable(c.x[i], c.y[i], scale)) {
      if (!parted) script += '\n';
      parted = true;
      continue;
    }
    fmt::format_to(std::back_inserter(script), "{} {}", c.x[i], c.y[i]);
    if (!c.shade.empty()) fmt::format_to(std::back_inserter(script), " {}", c.shade[i]);
    script += '\n';
    parted = false;
    ++drawn;
  }
  return drawn;
}

std::string style_of(const Curve& c, std::size_t number) {
  const std::string tint =
      c.shade.empty() ? fmt::format("rgb '{}'", colour(c.colour < 0 ? number : static_cast<std::size_t>(c.colour)))
                      : "palette";
  const char* style = c.points && c.lines ? "linespoints" : c.points ? "points" : "lines";
  return fmt::format("using {} with {} lc {}{}{} {}", c.shade.empty() ? "1:2" : "1:2:3", style, tint,
                     c.points ? fmt::format(" pt {} ps 0.4", std::array{7, 5, 9, 13}[c.dash % 4]) : "",
                     c.lines ? fmt::format(" lw 1.5 dt {}", c.dash + 1) : "",
                     c.title.empty() ? "notitle" : "title " + in_quotes(c.title));
}

// An axis for values of one sign starts at zero.
std::string base_line(const Figure& f) {
  bool positive = false, negative = false;
  for (const auto& c : f.curves)
    for (const double y : c.y) {
      positive |= y > 0.0;
      negative |= y < 0.0;
    }
  if (positive == negative) return "";
  return positive ? "set yrange [0:*]\n" : "set yrange [*:0]\n";
}

// Room for the legend below the plot: a row takes as many titles as fit, and gnuplot leaves out what does not fit at
// all.
void reserve_legend(const Figure& f, Drawing& d) {
  constexpr int kPlot = 400, kLargePlot = 560, kMany = 8, kRow = 17, kLetter = 8, kSample = 120;
  std::size_t longest = 0, titles = 0;
  for (const auto& c : f.curves) {
    longest = std::max(longest, c.title.size());
    titles += c.title.empty() ? 0 : 1;
  }
  const int title = kLetter * static_cast<int>(longest) + kSample;
  const bool many = titles > kMany;  // which want two columns at least
  d.width = std::max(d.width, (many ? 2 : 1) * title + kSample);
  const auto columns = static_cast<std::size_t>(d.width / title);
  d.height = (many ? kLargePlot : kPlot) + kRow * static_cast<int>((titles + columns - 1) / columns);
}

std::string head_of(const Drawing& d, const std::string& directory, const std::string& origin) {
  const std::string base = directory + "/" + d.name;
  return fmt::format(
      "# Drawn by {}.\nreset\nset encoding utf8\n"
      "set terminal svg size {},{} dynamic noenhanced background rgb 'white' font 'sans-serif,13'\nset output {}\n",
      origin, d.width, d.height, in_quotes(base + ".svg"));
}

std::string tail_of(const Drawing& d, const std::string& directory) {
  return fmt::format(
      "set terminal pngcairo size {},{} noenhanced background rgb 'white' font 'sans,13' fontscale 1.8 linewidth 2 "
      "pointscale 2\nset output {}\nreplot\nset output\n",
      2 * d.width, 2 * d.height, in_quotes(directory + "/" + d.name + ".png"));
}

}  // namespace

std::string colour(std::size_t number) { return kColours[number % kColours.size()]; }

std::string in_quotes(const std::string& text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? "''" : std::string(1, c == '\n' ? ' ' : c);
  return out + "'";
}

const std::vector<std::string>& palette() {  // viridis: even steps to the eye, in grey and without red or green as well
  static const std::vector<std::string> colours{"#440154", "#472d7b", "#3b528b", "#2c728e", "#21918c",
                                                "#28ae80", "#5ec962", "#addc30", "#fde725"};
  return colours;
}

std::string palette_commands() {
  std::string stops;
  for (std::size_t k = 0; k < palette().size(); ++k)
    stops += fmt::format("{}{} {}", k > 0 ? ", " : "", k, in_quotes(palette()[k]));
  return fmt::format("set palette defined ({}) maxcolors 64\n", stops);
}

Drawing drawing_of(const Figure& f, const std::string& name) {
  std::string s = fmt::format("set title {}\nset xlabel {} offset 0,0.3\nset ylabel {}\n", in_quotes(f.title),
                              in_quotes(f.x_label), in_quotes(f.y_label));
  s += "set grid lc rgb '#cccccc'\nset key outside bottom center horizontal samplen 2 title ' '\n";
  if (f.scale == Scale::LogLog) s += "set logscale xy\nset format xy '%.0e'\n";
  if (f.scale == Scale::LogY) s += "set logscale y\nset format y '%.0e'\n";
  if (!f.shade_label.empty()) s += palette_commands() + "set cblabel " + in_quotes(f.shade_label) + "\n";
  if (f.scale == Scale::Linear) s += base_line(f);
  for (const Note& note : f.notes)
    s += fmt::format("set label {} at first {}, first {} left offset 0.4, 0\n", in_quotes(note.text), note.x, note.y);
  std::string plot;
  for (std::size_t k = 0; k < f.curves.size(); ++k) {
    s += fmt::format("$curve{} << EOD\n", k);
    const std::size_t drawn = add_rows(s, f.curves[k], f.scale);
    s += "EOD\n";
    if (drawn > 0)
      plot += fmt::format("{}$curve{} {}", plot.empty() ? "plot " : ", \\\n  ", k, style_of(f.curves[k], k));
  }
  Drawing d{name, s + (plot.empty() ? kNothing : plot) + "\n"};
  reserve_legend(f, d);
  return d;
}

std::optional<std::string> draw(const std::vector<Drawing>& drawings, const std::string& directory,
                                const std::string& origin) {
  if (drawings.empty()) return std::nullopt;
  std::vector<std::string> command{"gnuplot"};
  for (const auto& d : drawings) {
    command.push_back(directory + "/" + d.name + ".gp");
    write_atomically(command.back(), head_of(d, directory, origin) + d.script + tail_of(d, directory));
  }
  const std::string log = directory + "/gnuplot.log";
  if (call({"gnuplot", "--version"}, log) != 0) {
    std::filesystem::remove(log);
    return "gnuplot cannot be started; it draws the figures: install it (Debian package gnuplot-nox)";
  }
  if (call(command, log) != 0) return "gnuplot could not draw the figures; " + log + " tells why";
  std::filesystem::remove(log);
  return std::nullopt;
}

void remove_drawings(const std::string& directory, const std::string& origin) {
  for (const auto& entry : std::filesystem::directory_iterator(directory)) {
    auto path = entry.path();
    if (path.extension() != ".gp") continue;
    std::string line;
    std::getline(std::ifstream(path), line);
    if (line != fmt::format("# Drawn by {}.", origin)) continue;
    for (const char* ending : {".gp", ".svg", ".png"}) std::filesystem::remove(path.replace_extension(ending));
  }
}

}  // namespace cleft::plot
