#include "cleft/verify/figure.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <iterator>

#include "cleft/scene/files.hpp"
#include "processes.hpp"

namespace cleft::verify {
namespace {

// Text between single quotes, where gnuplot reads nothing into it but a doubled quote.
std::string quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? "''" : std::string(1, c);
  return out + "'";
}

std::string script_of(const Figure& f, const std::string& svg) {
  std::string s = "set terminal svg size 800,560 dynamic enhanced background rgb 'white' font 'sans,13'\n";
  s += "set termoption noenhanced\n";
  s += fmt::format("set output {}\nset title {}\nset xlabel {}\nset ylabel {}\n", quoted(svg), quoted(f.title),
                   quoted(f.x_label), quoted(f.y_label));
  s += "set grid\nset key outside right top\n";
  if (f.logarithmic) s += "set logscale xy\nset format xy '%.0e'\n";
  std::string plot;
  for (std::size_t k = 0; k < f.curves.size(); ++k) {
    const Curve& c = f.curves[k];
    s += fmt::format("$curve{} << EOD\n", k);
    std::size_t drawn = 0;
    for (std::size_t i = 0; i < c.x.size(); ++i) {
      const bool usable =
          std::isfinite(c.x[i]) && std::isfinite(c.y[i]) && (!f.logarithmic || (c.x[i] > 0 && c.y[i] > 0));
      if (!usable) continue;
      fmt::format_to(std::back_inserter(s), "{} {}\n", c.x[i], c.y[i]);
      ++drawn;
    }
    s += "EOD\n";
    if (drawn == 0) continue;
    const char* style = c.points && c.lines ? "linespoints" : c.points ? "points" : "lines";
    plot += fmt::format("{}$curve{} with {} title {}", plot.empty() ? "plot " : ", \\\n  ", k, style, quoted(c.title));
  }
  return s + (plot.empty() ? "set xrange [0:1]\nset yrange [0:1]\nunset logscale\nplot NaN title 'no data'" : plot) +
         "\n";
}

}  // namespace

bool draw(const Figure& figure, const std::string& directory, const std::string& name) {
  const std::string base = directory + "/" + name, log = base + ".log";
  scene::write_atomically(base + ".gp", script_of(figure, base + ".svg"));
  const bool drawn = call({"gnuplot", base + ".gp"}, log) == 0;
  if (drawn) std::filesystem::remove(log);
  return drawn;
}

}  // namespace cleft::verify
