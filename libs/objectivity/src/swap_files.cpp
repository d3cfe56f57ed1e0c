#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "cleft/objectivity/swap.hpp"
#include "cleft/plot/figure.hpp"
#include "cleft/support/files.hpp"

namespace cleft::objectivity {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kOrigin = "cleft swap";

void add_values(std::string& out, const SwapMesh& mesh, const Solution& solution, const char* turned) {
  const auto add = [&](const std::string& quantity, const auto& value) {
    fmt::format_to(std::back_inserter(out), "{},{},{},{},{},{}\n", mesh.label, mesh.h, solution.side, turned, quantity,
                   value);
  };
  add("increments", solution.increments);
  add("iterations", solution.iterations);
  for (const auto& [name, force] : solution.reactions) {
    add("fx_" + name, force.x());
    add("fy_" + name, force.y());
  }
  for (const auto& [name, energy] : solution.energies) add(name, energy);
}

std::string values_csv(const SwapResult& result) {
  std::string out = "mesh,h,side,turned,quantity,value\n";
  for (const auto& mesh : result.meshes)
    for (const auto& solution : mesh.solutions) add_values(out, mesh, solution, "no");
  for (const auto& solution : result.turned) add_values(out, result.meshes[0], solution, "yes");
  return out;
}

std::string differences_csv(const SwapResult& result) {
  std::string out = "between,quantity,h,difference,order,order_pm,verdict,reason\n";
  for (const auto& [between, all] : {std::pair{"sides", &result.sides}, {"turned", &result.turn}})
    for (const auto& of : *all)
      for (std::size_t k = 0; k < of.h.size(); ++k)
        fmt::format_to(std::back_inserter(out), "{},\"{}\",{},{},{},{},{},\"{}\"\n", between, of.quantity, of.h[k],
                       of.difference[k], of.order, of.order_pm, of.verdict ? name_of(*of.verdict) : "", of.reason);
  return out;
}

// A profile and whose it is.
struct SideProfile {
  std::string side, turned;
  PressureProfile profile;
};

// Of one mesh, with the turned ones if they are of it.
std::vector<SideProfile> profiles_of(const SwapResult& result, const SwapMesh& mesh, const std::string& crack) {
  auto all = mesh.solutions;
  if (&mesh == &result.meshes[0]) all.insert(all.end(), result.turned.begin(), result.turned.end());
  std::vector<SideProfile> out;
  if (all.empty()) return out;
  for (auto& profile : pressure_profiles(all, crack))
    out.push_back({all[profile.solution].side, profile.solution < mesh.solutions.size() ? "no" : "yes", profile});
  return out;
}

std::string pressure_csv(const SwapResult& result) {
  std::string out = "mesh,crack,side,turned,face,place,pressure\n";
  for (const auto& mesh : result.meshes)
    for (const auto& crack : result.cracks)
      for (const auto& [side, turned, profile] : profiles_of(result, mesh, crack))
        for (std::size_t k = 0; k < profile.curve.place.size(); ++k)
          fmt::format_to(std::back_inserter(out), "{},{},{},{},{},{},{}\n", mesh.label, crack, side, turned,
                         profile.face, profile.curve.place[k], profile.curve.value[k]);
  return out;
}

Json json_of(const std::vector<Judgement>& all) {
  const auto number = [](double x) { return std::isfinite(x) ? Json(x) : Json(); };
  Json out = Json::array();
  for (const auto& of : all) {
    Json j{{"quantity", of.quantity}, {"h", of.h}, {"difference", Json::array()}};
    for (const double x : of.difference) j["difference"].push_back(number(x));
    j["order"] = number(of.order);
    j["order_pm"] = number(of.order_pm);
    j["verdict"] = of.verdict ? Json(name_of(*of.verdict)) : Json();
    j["reason"] = of.reason;
    out.push_back(std::move(j));
  }
  return out;
}

std::string swap_json(const SwapResult& result, const SwapOptions& options) {
  Json j{{"verdict", name_of(result.verdict)},
         {"cracks", result.cracks},
         {"load", options.load},
         {"part", options.part},
         {"tolerance", options.tolerance},
         {"least_order", options.least_order}};
  j["degrees"] = options.degrees ? Json(*options.degrees) : Json();
  j["turn_tolerance"] = kTurnTolerance;
  for (const auto& mesh : result.meshes) j["meshes"].push_back({{"label", mesh.label}, {"h", mesh.h}});
  j["sides"] = json_of(result.sides);
  j["turn"] = json_of(result.turn);
  j["failed"] = result.failed;
  return j.dump(2) + "\n";
}

// The pressures of the finest mesh over each other.
plot::Drawing pressure_drawing(const SwapResult& result, const std::string& crack, double load) {
  constexpr int kWide = 760;  // pixels, for the digits of millimetres in metres
  const SwapMesh& mesh = result.meshes.back();
  plot::Figure f;
  f.title = fmt::format("crack {} at load {:g}, mesh {}", crack, load, mesh.label);
  f.x_label = "current place along the crack, m";
  f.y_label = "pressure, Pa";
  for (const auto& [side, turned, profile] : profiles_of(result, mesh, crack)) {
    plot::Curve c;
    c.title = side == "both" ? "both, " + profile.face + " face" : side;
    if (std::string(turned) == "yes") c.title += ", turned";
    c.x = profile.curve.place;
    c.y = profile.curve.value;
    c.dash = static_cast<int>(f.curves.size());
    f.curves.push_back(std::move(c));
  }
  auto drawing = plot::drawing_of(f, "pressure_" + crack);
  drawing.width = std::max(drawing.width, kWide);
  return drawing;
}

plot::Figure difference_figure(const SwapResult& result, const std::string& title) {
  plot::Figure f;
  f.title = title;
  f.x_label = "h, m";
  f.y_label = "relative difference between sides";
  f.scale = plot::Scale::LogLog;
  for (const auto& of : result.sides) {
    plot::Curve& curve = f.curves.emplace_back();
    curve.title = of.quantity;
    curve.x = of.h;
    curve.y = of.difference;
  }
  return f;
}

}  // namespace

std::optional<std::string> write_swap(const SwapResult& result, const SwapOptions& options, const std::string& title) {
  const std::string& folder = options.directory;
  write_atomically(folder + "/values.csv", values_csv(result));
  write_atomically(folder + "/differences.csv", differences_csv(result));
  write_atomically(folder + "/pressure.csv", pressure_csv(result));
  write_atomically(folder + "/swap.json", swap_json(result, options));
  plot::remove_drawings(folder, kOrigin);
  std::vector<plot::Drawing> drawings;
  for (const auto& crack : result.cracks) drawings.push_back(pressure_drawing(result, crack, options.load));
  if (result.meshes.size() > 1) drawings.push_back(plot::drawing_of(difference_figure(result, title), "difference"));
  return plot::draw(drawings, folder, kOrigin);
}

}  // namespace cleft::objectivity
