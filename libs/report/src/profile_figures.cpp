#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "figures.hpp"
#include "unit.hpp"

namespace cleft::report {
namespace {

struct Quantity {
  const char* column;
  const char* title;
  const char* label;
  const char* unit;
  const char* caption;
  bool may_lack = false;  // runs of earlier versions
};

constexpr std::array kQuantities{
    Quantity{"tn", "Normal traction", "tn", "Pa", "Per reference area of the face; below 0 the faces press."},
    Quantity{"tt", "Tangential traction", "tt", "Pa",
             "Per reference area of the face, positive along the crack's direction."},
    Quantity{"pressure", "Contact pressure", "Cauchy pressure", "Pa",
             "Per current area of the face, positive in compression."},
    Quantity{"slip", "Slip", "cumulative slip", "m", "All sliding so far; it stays with a point that opens."},
    Quantity{"gap", "Gap", "gap", "m", "Below 0 the faces overlap; no value where nothing is opposite."},
    Quantity{"opening", "Opening", "opening", "m", "Distance of the faces, 0 where they touch.", true},
    Quantity{"jump_t", "Tangential jump", "tangential jump", "m",
             "By which the left face has moved along the crack's direction past the right one, open or closed.", true}};

// The rows of one output and face.
struct Part {
  std::string output;  // as the legend has it
  std::string side;
  std::vector<std::size_t> rows;  // by rising s
};

struct Profile {
  const CsvTable& table;
  std::string path;
  std::vector<double> column(const char* name) const { return column_of(table, name, path); }

  // Of `most` outputs at even distances, the last among them.
  std::vector<Part> parts(std::size_t most) const {
    const auto load = column("load"), step = column("step"), s = column("s");
    std::vector<std::size_t> first;  // row of each output
    for (std::size_t i = 0; i < step.size(); ++i)
      if (i == 0 || step[i] != step[i - 1]) first.push_back(i);
    const std::size_t count = std::min(most, first.size());
    std::vector<Part> out;
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t at = first[(k + 1) * first.size() / count - 1];
      const bool repeated = std::ranges::count_if(first, [&](std::size_t i) { return load[i] == load[at]; }) > 1;
      for (const char* side : {"left", "right"}) {
        Part part{fmt::format("load {:.4g}", load[at]), side, {}};
        if (repeated) part.output += fmt::format(" (increment {})", step[at]);
        for (std::size_t i = at; i < step.size() && step[i] == step[at]; ++i)
          if (table.rows[i].at(1) == side) part.rows.push_back(i);
        std::ranges::stable_sort(part.rows, {}, [&](std::size_t i) { return s[i]; });
        if (!part.rows.empty()) out.push_back(std::move(part));
      }
    }
    return out;
  }
};

std::vector<double> pick(const std::vector<double>& values, const std::vector<std::size_t>& rows) {
  std::vector<double> out;
  for (const std::size_t i : rows) out.push_back(values[i]);
  return out;
}

bool lacks(const CsvTable& table, const Quantity& q) {
  return q.may_lack && std::ranges::find(table.header, q.column) == table.header.end();
}

// Colours tell outputs of runs apart, dashes the faces.
std::vector<plot::Curve> curves_of(const std::vector<Run>& runs, const std::string& crack, const Quantity& q) {
  constexpr std::size_t kMostOutputs = 6, kMarks = 80;
  std::vector<plot::Curve> curves;
  int colour = -1;
  for (std::size_t r = 0; r < runs.size(); ++r)
    for (const auto& c : runs[r].cracks) {
      if (c.name != crack || lacks(c.profile, q)) continue;
      const Profile profile{c.profile, runs[r].directory + "/crack_" + crack + ".csv"};
      const auto s = profile.column("s"), y = profile.column(q.column);
      std::string output;
      for (const auto& part : profile.parts(std::max<std::size_t>(1, kMostOutputs / runs.size()))) {
        if (part.output != std::exchange(output, part.output)) ++colour;
        plot::Curve curve;
        curve.title = with_label(runs, r, fmt::format("{}, {} face", part.output, part.side));
        curve.x = pick(s, part.rows);
        curve.y = pick(y, part.rows);
        curve.colour = colour;
        curve.dash = part.side == "left" ? 0 : 1;
        curve.points = curve.x.size() <= kMarks;
        curves.push_back(std::move(curve));
      }
    }
  return curves;
}

bool in_any(const std::vector<Run>& runs, const std::string& crack, const Quantity& q) {
  return std::ranges::any_of(runs, [&](const Run& run) {
    return std::ranges::any_of(run.cracks, [&](const auto& c) { return c.name == crack && !lacks(c.profile, q); });
  });
}

PageFigure figure_of(const std::vector<Run>& runs, const std::string& crack, const Quantity& q) {
  plot::Figure f;
  f.curves = curves_of(runs, crack, q);
  double far = 0.0, most = 0.0;
  for (const auto& c : f.curves) {
    far = std::max(far, largest_of(c.x));
    most = std::max(most, largest_of(c.y));
  }
  const Unit along = unit_for(far, "m"), unit = unit_for(most, q.unit);
  for (auto& c : f.curves) {
    for (double& x : c.x) x *= along.scale;
    for (double& y : c.y) y *= unit.scale;
  }
  const auto one_face = [&](const std::string& face) {
    return std::ranges::all_of(f.curves, [&](const plot::Curve& c) { return c.title.ends_with(face); });
  };
  f.title = fmt::format("{} along crack {}", q.title, crack);
  for (const std::string face : {", left face", ", right face"})
    if (one_face(face)) {
      f.title += face;
      for (auto& c : f.curves) {
        c.title.resize(c.title.size() - face.size());
        c.dash = 0;
      }
    }
  f.x_label = along.label("reference arc length s");
  f.y_label = unit.label(q.label);
  return {plot::drawing_of(f, fmt::format("crack_{}_{}", crack, q.column)), q.caption};
}

}  // namespace

PageFigures profile_figures(const std::vector<Run>& runs) {
  std::set<std::string> cracks;
  for (const auto& run : runs)
    for (const auto& crack : run.cracks) cracks.insert(crack.name);
  PageFigures figures;
  for (const auto& crack : cracks)
    for (const auto& q : kQuantities)
      if (in_any(runs, crack, q)) figures.push_back(figure_of(runs, crack, q));
  return figures;
}

}  // namespace cleft::report
