// Outputs in numbers of few bits: positions with 16, colours with 8.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "cleft/support/base64.hpp"
#include "page.hpp"
#include "unit.hpp"

namespace cleft::report {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::uint8_t kNoValue = 255;

template <class T>
std::string encoded(const std::vector<T>& values) {
  return to_base64(values.data(), values.size() * sizeof(T));
}

std::vector<std::uint16_t> places(const Shape& shape, const Box& box) {
  std::vector<std::uint16_t> out;
  for (const Vec2& x : shape.points)
    for (const int k : {0, 1}) {
      const double width = box.high[k] - box.low[k];
      out.push_back(static_cast<std::uint16_t>(std::lround(width > 0.0 ? 65535.0 * (x[k] - box.low[k]) / width : 0.0)));
    }
  return out;
}

std::vector<std::int16_t> moves(const Shape& shape, double largest) {
  std::vector<std::int16_t> out;
  for (const Vec2& u : shape.displacement)
    for (const int k : {0, 1})
      out.push_back(static_cast<std::int16_t>(std::lround(largest > 0.0 ? 32767.0 * u[k] / largest : 0.0)));
  return out;
}

std::vector<std::uint8_t> tints(const std::vector<float>& values, const Range& range) {
  std::vector<std::uint8_t> out;
  for (const float v : values) {
    const double share = std::clamp((v - range.low) / (range.high - range.low), 0.0, 1.0);
    out.push_back(std::isfinite(v) ? static_cast<std::uint8_t>(std::lround(share * (kNoValue - 1))) : kNoValue);
  }
  return out;
}

Json described(const FieldKind& kind, const Range& range) {
  const Unit unit = unit_for(std::max(std::fabs(range.low), std::fabs(range.high)), kind.unit);
  const auto number = [&](double v) { return fmt::format("{:.4g}", unit.scale * v); };
  return {{"name", kind.name},
          {"title", unit.label(kind.title)},
          {"low", number(range.low)},
          {"high", number(range.high)},
          {"extremes",
           fmt::format("Over the outputs here from {} to {}; the hundredth at each end has the colour of the end.",
                       number(range.least), number(range.most))}};
}

// Name and value of what history.csv has for the output.
Json numbers_of(const Run& run, const Shape& shape) {
  Json out = Json::array();
  if (!shape.row) return out;
  for (const auto& name : run.history.header) {
    const bool force = name.starts_with("fx_") || name.starts_with("fy_");
    const std::string unit = force ? "N/m" : name == "max_slip" ? "m" : name == "max_pressure" ? "Pa" : "";
    if (unit.empty() && name != "iterations") continue;
    const auto column = run.column(name);
    const Unit readable = unit_for(std::fabs(column[*shape.row]), unit);
    out.push_back({name, fmt::format("{:.5g} {}", readable.scale * column[*shape.row], readable.name)});
  }
  return out;
}

std::string title_of(const Run& run, const Shape& shape) {
  std::string out = fmt::format("load {:.6g}", shape.load);
  if (shape.row) out += ", increment " + run.history.rows[*shape.row].front();
  return out;
}

bool same_mesh(const Shape& a, const Shape& b) { return a.triangles == b.triangles && a.points == b.points; }

double largest_displacement(const Run& run) {
  double largest = 0.0;
  for (const auto& shape : run.shapes)
    for (const Vec2& u : shape.displacement) largest = std::max(largest, u.cwiseAbs().maxCoeff());
  return largest;
}

Json json_of(const Run& run) {
  const double largest = largest_displacement(run);
  const auto pair = [](const Vec2& x) { return Json{x.x(), x.y()}; };
  Json j{{"label", run.label},
         {"factor", run.factor},
         {"low", pair(run.reference.low)},
         {"high", pair(run.reference.high)},
         {"displacement", largest},
         {"fields", Json::array()},
         {"meshes", Json::array()},
         {"shapes", Json::array()}};
  for (std::size_t k = 0; k < run.fields.size(); ++k) j["fields"].push_back(described(run.fields[k], run.ranges[k]));
  const Shape* last = nullptr;
  for (const Shape& shape : run.shapes) {
    if (!last || !same_mesh(*last, shape))
      j["meshes"].push_back(
          {{"bulk", shape.bulk_points},
           {"points", encoded(places(shape, run.reference))},
           {"triangles", encoded(std::vector<std::uint32_t>(shape.triangles.begin(), shape.triangles.end()))}});
    last = &shape;
    Json s{{"mesh", j["meshes"].size() - 1},
           {"load", shape.load},
           {"title", title_of(run, shape)},
           {"numbers", numbers_of(run, shape)},
           {"displacement", encoded(moves(shape, largest))},
           {"values", Json::array()}};
    for (std::size_t f = 0; f < run.fields.size(); ++f)
      s["values"].push_back(encoded(tints(shape.values[f], run.ranges[f])));
    j["shapes"].push_back(std::move(s));
  }
  return j;
}

}  // namespace

std::string shapes_json(const std::vector<Run>& runs) {
  Json j{{"palette", plot::palette()}, {"runs", Json::array()}};
  for (const auto& run : runs)
    if (!run.shapes.empty()) j["runs"].push_back(json_of(run));
  std::string out;
  for (const char c : j.dump(-1, ' ', true, Json::error_handler_t::replace)) {
    if (c == '<')
      out += "\\u003c";  // so that no text can end the script
    else
      out += c;
  }
  return out;
}

}  // namespace cleft::report
