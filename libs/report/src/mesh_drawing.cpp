#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include "figures.hpp"
#include "unit.hpp"

namespace cleft::report {
namespace {

// Where a drawing's axes begin, metres: a body far from its coordinates' origin is drawn from a round number near it,
// so that a few digits tell its points apart.
Vec2 beginning_of(const Box& box) {
  constexpr double kFar = 100.0;  // sizes of the body
  const double size = (box.high - box.low).maxCoeff();
  if (!(std::max(box.low.cwiseAbs().maxCoeff(), box.high.cwiseAbs().maxCoeff()) > kFar * size)) return Vec2::Zero();
  const double round = std::pow(10.0, std::floor(std::log10(size)));
  return {round * std::floor(box.low.x() / round), round * std::floor(box.low.y() / round)};
}

// From metres to the drawing.
struct Placement {
  Vec2 beginning;
  double factor, scale;  // of displacements, of everything
  Vec2 operator()(const Shape& shape, std::size_t n) const {
    return scale * (shape.points[n] - beginning + factor * shape.displacement[n]);
  }
};

// Triangles as closed lines of x, y and value; a value that is not finite stays white.
std::string triangles_of(const Shape& shape, std::size_t field, const Placement& place, const Unit& unit) {
  std::string rows;
  for (std::size_t t = 0; t < shape.triangles.size(); t += 3) {
    const double value = shape.values[field][t / 3] * unit.scale;
    if (!std::isfinite(value)) continue;
    for (const std::size_t corner : {0, 1, 2, 0}) {
      const auto n = static_cast<std::size_t>(shape.triangles[t + corner]);
      const Vec2 x = place(shape, n);
      fmt::format_to(std::back_inserter(rows), "{:.5g} {:.5g} {:.4g}\n", x.x(), x.y(), value);
    }
    rows += '\n';
  }
  return rows;
}

std::string faces_of(const Shape& shape, const Placement& place) {
  std::string rows;
  for (std::size_t n = shape.bulk_points; n < shape.points.size(); ++n) {
    const Vec2 x = place(shape, n);
    fmt::format_to(std::back_inserter(rows), "{:.5g} {:.5g}\n{}", x.x(), x.y(),
                   (n - shape.bulk_points) % 2 ? "\n" : "");
  }
  return rows;
}

}  // namespace

plot::Drawing mesh_drawing(const Run& run, const Shape& shape, std::size_t field, const std::string& prefix) {
  constexpr std::size_t kManyTriangles = 6000;  // whose edges would hide the colours
  const double factor = run.factor;
  const Box& box = run.drawn;
  const Vec2 size = box.high - box.low;
  const auto& kind = run.fields[field];
  const Range& range = run.ranges[field];
  const Unit metres = unit_for(size.maxCoeff(), "m"),
             unit = unit_for(std::max(std::fabs(range.low), std::fabs(range.high)), kind.unit);
  plot::Drawing d{fmt::format("{}{}_{:04}", prefix, kind.name, shape.number), ""};
  d.height = static_cast<int>(std::clamp(120.0 + 340.0 * size.y() / size.x(), 300.0, 760.0));
  const Placement place{beginning_of(box), factor, metres.scale};
  const Vec2 low = metres.scale * (box.low - place.beginning - 0.02 * size),
             high = metres.scale * (box.high - place.beginning + 0.02 * size);
  const auto axis = [&](char letter) {
    const double from = letter == 'x' ? place.beginning.x() : place.beginning.y();
    return plot::in_quotes(
        metres.label((factor == 1.0 ? std::string(1, letter)
                                    : fmt::format("{} + {:g} u{}", letter == 'x' ? 'X' : 'Y', factor, letter)) +
                     (from == 0.0 ? "" : fmt::format(" {} {} m", from < 0.0 ? '+' : '-', std::fabs(from)))));
  };
  d.script = fmt::format(
      "set title {}\nset xlabel {}\nset ylabel {}\nset cblabel {}\nset cbrange [{:.6g}:{:.6g}]\n"
      "set xrange [{:.6g}:{:.6g}]\nset yrange [{:.6g}:{:.6g}]\nset size ratio -1\n{}",
      plot::in_quotes(fmt::format("{} at load {:.4g}{}", run.label, shape.load,
                                  factor == 1.0 ? "" : fmt::format(", displacements x {:g}", factor))),
      axis('x'), axis('y'), plot::in_quotes(unit.label(kind.title)), unit.scale * range.low, unit.scale * range.high,
      low.x(), high.x(), low.y(), high.y(), plot::palette_commands());
  d.script += "$triangles << EOD\n" + triangles_of(shape, field, place, unit) + "EOD\n$faces << EOD\n" +
              faces_of(shape, place) + "EOD\n";
  d.script += "plot $triangles using 1:2:3 with polygons fs solid noborder fc palette z notitle";
  if (shape.triangles.size() / 3 <= kManyTriangles)
    d.script += ", $triangles using 1:2 with lines lc rgb '#b0000000' lw 0.3 notitle";
  if (shape.points.size() > shape.bulk_points)
    d.script += ", $faces using 1:2 with lines lc rgb 'black' lw 1.5 notitle";
  d.script += '\n';
  return d;
}

}  // namespace cleft::report
