#include <algorithm>
#include <array>
#include <map>

#include "cleft/problem/specification.hpp"
#include "figures.hpp"
#include "unit.hpp"

namespace cleft::report {
namespace {

struct Column {
  const char* name;
  const char* title;
};

bool all_zero(const std::vector<double>& values) {
  return std::ranges::all_of(values, [](double v) { return v == 0.0; });
}

// The columns of every run over the load, but those that stay zero.
std::vector<plot::Curve> over_load(const std::vector<Run>& runs, const std::vector<Column>& columns) {
  std::vector<plot::Curve> curves;
  for (std::size_t r = 0; r < runs.size(); ++r)
    for (std::size_t k = 0; k < columns.size(); ++k) {
      auto y = runs[r].column(columns[k].name);
      if (y.empty() || all_zero(y)) continue;
      plot::Curve c = curve_of(runs, r, k, columns[k].title);
      c.x = runs[r].column("load");
      c.y = std::move(y);
      curves.push_back(std::move(c));
    }
  return curves;
}

// Names of boundaries that have a column fx_NAME or fy_NAME.
std::vector<std::string> boundaries_of(const Run& run, const std::string& prefix) {
  std::vector<std::string> names;
  for (const auto& column : run.history.header)
    if (column.starts_with(prefix)) names.push_back(column.substr(prefix.size()));
  return names;
}

// The displacement that a scene prescribes a boundary at each load; nothing unless it is one number that is not zero.
std::vector<double> displacement_of(const Run& run, const std::string& boundary, const char* component) {
  if (!run.info.is_object() || !run.info.contains("scene")) return {};
  for (const auto& b : run.info["scene"].value("boundary", nlohmann::ordered_json::array())) {
    if (b.value("name", "") != boundary || b.contains("rotation") || b.value(component, 0.0) == 0.0) continue;
    problem::Amplitude factor;
    factor.points = b.at("amplitude").get<decltype(factor.points)>();
    std::vector<double> u;
    for (const double load : run.column("load")) u.push_back(b[component].get<double>() * factor(load));
    return u;
  }
  return {};
}

void add_reactions(PageFigures& figures, const std::vector<Run>& runs, char axis) {
  const std::string force = std::string("f") + axis + "_", component = std::string("u") + axis;
  Sketch load, displacement;
  std::vector<double> all;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const auto names = boundaries_of(runs[r], force);
    for (std::size_t k = 0; k < names.size(); ++k) {
      plot::Curve c = curve_of(runs, r, k, names[k]);
      c.x = runs[r].column("load");
      c.y = runs[r].column(force + names[k]);
      load.curves.push_back(c);
      c.x = displacement_of(runs[r], names[k], component.c_str());
      if (c.x.empty()) continue;
      all.insert(all.end(), c.x.begin(), c.x.end());
      displacement.curves.push_back(c);
    }
  }
  load.name = std::string("reaction_") + axis;
  load.title = std::string("Reactions in ") + axis;
  load.x_label = "load";
  load.y_label = std::string("force on the body f") + axis;
  load.y_unit = "N/m";
  load.caption = "Force that each boundary exerts on the body, per unit thickness, positive along the axis.";
  displacement.name = load.name + "_displacement";
  displacement.title = load.title + " over the prescribed displacement";
  displacement.y_label = load.y_label;
  displacement.y_unit = load.y_unit;
  displacement.caption = "Of the boundaries to which the scene prescribes one displacement.";
  const Unit metres = unit_for(largest_of(all), "m");
  for (auto& c : displacement.curves)
    for (double& x : c.x) x *= metres.scale;
  displacement.x_label = metres.label(component);
  add(figures, std::move(load));
  add(figures, std::move(displacement));
}

struct Plot {
  const char* name;
  const char* title;
  const char* y_label;
  const char* unit;
  std::vector<Column> columns;
  const char* caption = "";
};

const std::vector<Plot>& plots() {
  static const std::vector<Plot> all{
      {"energies",
       "Energies",
       "energy",
       "J/m",
       {{"external_work", "external work"},
        {"elastic_energy", "elastic"},
        {"contact_energy", "contact"},
        {"friction_dissipation", "friction"},
        {"contact_pressure_work", "contact pressure"},
        {"plastic_dissipation", "plastic"},
        {"viscous_dissipation", "viscous"},
        {"released_energy", "released by growth"}},
       "Per unit thickness. The external work is the sum of the others but for the imbalance in the table."},
      {"contact_points",
       "Contact points",
       "contact points",
       "",
       {{"contact_points", "in contact"}, {"slipping_points", "of these slipping"}}},
      {"max_pressure", "Largest contact pressure", "Cauchy pressure", "Pa", {{"max_pressure", ""}}},
      {"max_slip", "Largest cumulative slip", "slip", "m", {{"max_slip", ""}}},
      {"min_gap",
       "Least gap",
       "gap",
       "m",
       {{"min_gap", ""}},
       "Between faces that are opposite each other; below 0 the faces overlap."},
      {"max_plastic_strain", "Largest plastic strain", "sum of multipliers", "", {{"max_plastic_strain", ""}}},
      {"min_localisation",
       "Localisation",
       "least localisation function",
       "",
       {{"min_localisation", ""}},
       "Below 0 the flow may localise."}};
  return all;
}

void add_intensities(PageFigures& figures, const std::vector<Run>& runs) {
  for (const std::string mode : {"k1", "k2"}) {
    Sketch s;
    for (std::size_t r = 0; r < runs.size(); ++r) {
      std::size_t k = 0;
      for (const auto& name : runs[r].history.header) {
        if (!name.starts_with(mode + "_")) continue;
        plot::Curve c = curve_of(runs, r, k, name);
        c.x = runs[r].column("load");
        c.y = runs[r].column(name);
        if (std::ranges::any_of(c.y, [](double v) { return v == v; })) s.curves.push_back(std::move(c));
        ++k;
      }
    }
    s.name = mode;
    s.title = mode == "k1" ? "Stress intensity, mode I" : "Stress intensity, mode II";
    s.x_label = "load";
    s.y_label = mode;
    s.y_unit = "Pa m^0.5";
    s.caption = "By the interaction integral, and with faces in the name from opening and slip.";
    add(figures, std::move(s));
  }
}

// The length that every tip has grown, as stairs over the load.
void add_growth(PageFigures& figures, const std::vector<Run>& runs) {
  Sketch s;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    if (!runs[r].growth) continue;
    const auto& table = *runs[r].growth;
    const std::string path = runs[r].directory + "/growth.csv";
    const auto load = column_of(table, "load", path), length = column_of(table, "length", path);
    std::map<std::string, plot::Curve> tips;
    for (std::size_t k = 0; k < load.size(); ++k) {
      const std::string name = table.rows[k].at(2) + ", " + table.rows[k].at(3);  // crack and tip
      if (!tips.contains(name)) tips[name] = curve_of(runs, r, tips.size(), name);
      plot::Curve& c = tips[name];
      c.points = false;
      const double before = c.y.empty() ? 0.0 : c.y.back();
      c.x.insert(c.x.end(), {load[k], load[k]});
      c.y.insert(c.y.end(), {before, before + length[k]});
    }
    for (auto& [name, c] : tips) s.curves.push_back(std::move(c));
  }
  s.name = "growth";
  s.title = "Growth of the cracks";
  s.x_label = "load";
  s.y_label = "length grown by the tip";
  s.y_unit = "m";
  add(figures, std::move(s));
}

}  // namespace

PageFigures reaction_figures(const std::vector<Run>& runs) {
  PageFigures figures;
  add_reactions(figures, runs, 'x');
  add_reactions(figures, runs, 'y');
  return figures;
}

PageFigures history_figures(const std::vector<Run>& runs) {
  PageFigures figures;
  for (const auto& p : plots())
    add(figures,
        {p.name, p.title, "load", p.y_label, p.unit, p.caption, plot::Scale::Linear, over_load(runs, p.columns)});
  add_intensities(figures, runs);
  add_growth(figures, runs);
  return figures;
}

}  // namespace cleft::report
