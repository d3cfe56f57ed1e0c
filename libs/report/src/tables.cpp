#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <iterator>
#include <map>

#include "cleft/scene/scene_difference.hpp"
#include "page.hpp"
#include "unit.hpp"

namespace cleft::report {
namespace {

using Json = nlohmann::ordered_json;

std::string row_of(const char* tag, const std::vector<std::string>& cells) {
  std::string out = "<tr>";
  for (const auto& cell : cells) out += fmt::format("<{}>{}</{}>", tag, escaped(cell), tag);
  return out + "</tr>\n";
}

std::string table_of(const char* kind, const std::vector<std::string>& head,
                     const std::vector<std::vector<std::string>>& rows) {
  if (rows.empty()) return "";
  std::string out = fmt::format("<div class=\"scroll\"><table class=\"{}\">\n<thead>", kind) + row_of("th", head) +
                    "</thead>\n<tbody>\n";
  for (const auto& row : rows) out += row_of("td", row);
  return out + "</tbody></table></div>\n";
}

// A value of run.json as text; empty if it is not there.
std::string text_at(const Json& info, const std::string& pointer) {
  const Json::json_pointer at(pointer);
  if (!info.contains(at)) return "";
  const Json& value = info.at(at);
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number_integer()) return fmt::format("{}", value.get<long>());
  if (value.is_number()) return fmt::format("{:.4g}", value.get<double>());
  return value.dump();
}

double last_of(const Run& run, const std::string& column) {
  const auto values = run.column(column);
  return values.empty() ? std::nan("") : values.back();
}

double sum_of(const Run& run, const std::string& column) {
  double sum = 0.0;
  for (const double v : run.column(column)) sum += v;
  return sum;
}

std::vector<std::string> head_of(const std::vector<Run>& runs, const char* first) {
  std::vector<std::string> head{first};
  for (const auto& run : runs) head.push_back(run.label);
  return head;
}

// A row with one cell a run, unless all of them are empty.
void add(std::vector<std::vector<std::string>>& rows, const std::vector<Run>& runs, const std::string& name,
         const std::function<std::string(const Run&)>& cell) {
  std::vector<std::string> row{name};
  bool empty = true;
  for (const auto& run : runs) {
    row.push_back(cell(run));
    empty &= row.back().empty();
  }
  if (!empty) rows.push_back(std::move(row));
}

std::string number(double v) { return std::isnan(v) ? "" : fmt::format("{:.6g}", v); }

std::string with_unit(double v, const char* unit) {
  if (std::isnan(v)) return "";
  const Unit readable = unit_for(std::fabs(v), unit);
  return fmt::format("{:.6g} {}", readable.scale * v, readable.name);
}

// A number with the digits that a reader needs; other text as it is.
std::string rounded(const std::string& cell) {
  char* end = nullptr;
  const double value = std::strtod(cell.c_str(), &end);
  return cell.empty() || *end != '\0' ? cell : std::isnan(value) ? "" : fmt::format("{:.5g}", value);
}

// The columns of reactions that any of the runs has.
std::vector<std::string> reactions_of(const std::vector<Run>& runs) {
  std::vector<std::string> out;
  for (const auto& run : runs)
    for (const auto& column : run.history.header)
      if ((column.starts_with("fx_") || column.starts_with("fy_")) && std::ranges::find(out, column) == out.end())
        out.push_back(column);
  return out;
}

struct Energy {
  const char* column;
  const char* title;
  int sign;  // with which it takes part in the imbalance
};
constexpr std::array kEnergies{Energy{"external_work", "external work", 1},
                               Energy{"elastic_energy", "elastic energy", -1},
                               Energy{"contact_energy", "contact energy", -1},
                               Energy{"plastic_dissipation", "plastic dissipation", -1},
                               Energy{"viscous_dissipation", "viscous dissipation", -1},
                               Energy{"friction_dissipation", "friction dissipation", -1},
                               Energy{"contact_pressure_work", "work of the contact pressure", -1},
                               Energy{"released_energy", "released by growth", -1}};

double imbalance_of(const Run& run) {
  double sum = 0.0;
  for (const auto& e : kEnergies)
    if (const double v = last_of(run, e.column); !std::isnan(v)) sum += e.sign * v;
  return sum;
}

// The largest that any energy has been, J/m.
double largest_energy(const Run& run) {
  double out = 0.0;
  for (const auto& e : kEnergies)
    for (const double v : run.column(e.column)) out = std::max(out, std::fabs(v));
  return out;
}

}  // namespace

std::string summary_table(const std::vector<Run>& runs) {
  std::vector<std::vector<std::string>> rows;
  const auto from_info = [&](const char* name, const char* pointer) {
    add(rows, runs, name, [&](const Run& run) { return text_at(run.info, pointer); });
  };
  from_info("scene", "/scene/file");
  add(rows, runs, "end of the run",
      [](const Run& run) { return run.info.is_null() ? "not ended: no run.json" : text_at(run.info, "/end"); });
  add(rows, runs, "load reached", [](const Run& run) { return number(last_of(run, "load")); });
  from_info("nodes", "/mesh/nodes");
  from_info("elements", "/mesh/elements");
  from_info("cut elements", "/mesh/cut_elements");
  from_info("unknowns, standard", "/unknowns/standard");
  from_info("unknowns, enriched", "/unknowns/enriched");
  from_info("unknowns, tips", "/unknowns/tips");
  from_info("unknowns, multipliers", "/unknowns/multipliers");
  from_info("contact points", "/unknowns/contact_points");
  add(rows, runs, "increments", [](const Run& run) { return fmt::format("{}", run.history.rows.size()); });
  add(rows, runs, "iterations", [](const Run& run) { return number(sum_of(run, "iterations")); });
  add(rows, runs, "cuts of increments", [](const Run& run) { return number(sum_of(run, "cuts")); });
  from_info("worst residual left (relative)", "/worst_residual");
  add(rows, runs, "order of Newton's iteration", [](const Run& run) {
    const std::string order = text_at(run.info, "/newton_order");
    return order == "null" ? std::string() : order;  // none could be told
  });
  from_info("largest overlap, element sizes", "/overlap");
  for (const auto& column : reactions_of(runs))
    add(rows, runs, column + " at the end", [&](const Run& run) { return with_unit(last_of(run, column), "N/m"); });
  from_info("time, s", "/seconds/total");
  from_info("peak memory, MB", "/peak_megabytes");
  from_info("version of cleft", "/cleft");
  return table_of("runs", head_of(runs, ""), rows);
}

std::string differences_table(const std::vector<Run>& runs) {
  std::vector<std::string> keys;
  std::map<std::string, std::vector<std::string>> values;  // a cell for each run
  for (std::size_t r = 0; r < runs.size(); ++r) {
    if (!runs[r].info.is_object() || !runs[r].info.contains("scene")) continue;
    for (const auto& [key, value] : scene::keys_and_values(runs[r].info["scene"].dump())) {
      const auto [at, added] = values.try_emplace(key, runs.size());
      if (added) keys.push_back(key);
      at->second[r] = value;
    }
  }
  std::vector<std::vector<std::string>> rows;
  for (const auto& key : keys) {
    auto& row = values.at(key);
    const bool all_equal = std::ranges::all_of(row, [&](const std::string& value) { return value == row.front(); });
    if (all_equal || key == "title" || key == "file") continue;
    row.insert(row.begin(), key);
    rows.push_back(row);
  }
  return table_of("runs", head_of(runs, "key"), rows);
}

std::string energy_table(const std::vector<Run>& runs) {
  std::vector<std::vector<std::string>> rows;
  for (const auto& e : kEnergies)
    add(rows, runs, e.title, [&](const Run& run) { return with_unit(last_of(run, e.column), "J/m"); });
  if (rows.empty()) return "";
  add(rows, runs, "imbalance", [](const Run& run) {
    const double largest = largest_energy(run), error = imbalance_of(run);
    if (std::isnan(last_of(run, "external_work"))) return std::string();
    return with_unit(error, "J/m") +
           (largest == 0.0 ? "" : fmt::format(" ({:.2g} % of the largest energy)", 100.0 * error / largest));
  });
  return table_of("runs", head_of(runs, "at the end, per unit thickness"), rows);
}

std::string growth_table(const std::vector<Run>& runs) {
  std::string out;
  for (const auto& run : runs) {
    if (!run.growth) continue;
    auto rows = run.growth->rows;
    for (auto& row : rows)
      for (auto& cell : row) cell = rounded(cell);
    const std::string table = table_of("long", run.growth->header, rows);
    if (!table.empty() && runs.size() > 1) out += "<p>" + escaped(run.label) + "</p>\n";
    out += table;
  }
  return out;
}

std::string phase_table(const std::vector<Run>& runs) {
  std::vector<std::string> names;
  for (const auto& run : runs)
    for (const auto& [name, seconds] : phases_of(run))
      if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  std::vector<std::vector<std::string>> rows;
  for (const auto& name : names)
    add(rows, runs, name, [&](const Run& run) {
      double total = 0.0, seconds = std::nan("");
      for (const auto& [phase, s] : phases_of(run)) {
        total += s;
        if (phase == name) seconds = s;
      }
      return std::isnan(seconds)
                 ? ""
                 : fmt::format("{:.3g} s ({:.1f} %)", seconds, total > 0.0 ? 100.0 * seconds / total : 0.0);
    });
  return table_of("runs", head_of(runs, "phase"), rows);
}

}  // namespace cleft::report
