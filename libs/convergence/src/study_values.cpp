#include "study_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "cleft/convergence/curve_distance.hpp"
#include "cleft/simulation/contents.hpp"
#include "cleft/simulation/run.hpp"
#include "cleft/support/files.hpp"

namespace cleft::convergence {
namespace {

using scene::Quantity;

constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

nlohmann::json run_json(const StudyRun& run) { return nlohmann::json::parse(read_bytes(run.folder + "/run.json")); }

double history_value(const StudyRun& run, const Quantity& q) {
  const auto table = read_csv(run.folder + "/history.csv");
  return table.column(q.column)[last_row_at(table, q.load)];
}

// Of a crack whose faces both have points, one face: their tractions are opposite and their places have moved apart.
void keep_side(CsvTable& table, const std::string& wanted) {
  const auto at = std::find(table.header.begin(), table.header.end(), "side");
  if (at == table.header.end()) return;
  const auto column = static_cast<std::size_t>(at - table.header.begin());
  const auto on = [&](const char* side) { return [column, side](const auto& row) { return row.at(column) == side; }; };
  const std::string side = !wanted.empty() ? wanted : std::ranges::any_of(table.rows, on("left")) ? "left" : "right";
  std::erase_if(table.rows, [&](const auto& row) { return row.at(column) != side; });
}

// The curve of a table: its rows at the quantity's load; all rows of a table without loads.
Curve curve_of(const std::string& path, const Quantity& q) {
  auto table = read_csv(path);
  if (std::ranges::find(table.header, "load") != table.header.end()) table = last_state_at(table, q.load);
  keep_side(table, q.side);
  return {table.column(q.along), table.column(q.column)};
}

Curve profile_of(const StudyRun& run, const Quantity& q) {
  Curve out = curve_of(run.folder + "/crack_" + q.crack + ".csv", q);
  if (out.place.empty()) throw std::runtime_error(fmt::format("{}: no profile at load {}", run.folder, q.load));
  return out;
}

double profile_value(const StudyRun& run, const Quantity& q, const Curve& reference) {
  const Curve own = profile_of(run, q);
  const auto range = q.range ? q.range : common_range(own, reference);
  if (!range)
    throw std::runtime_error(fmt::format("{}: '{}' has no part of the abscissa in common", run.folder, q.name));
  const auto d = distance(own, reference, *range);
  return q.largest ? d.largest_relative : d.l2_relative;
}

// Does what reads files of a run. If it cannot be done that is the run's failure, unless it has one already.
template <class Read>
void guarded(StudyRun& run, const Read& read) {
  try {
    read();
  } catch (const std::exception& error) {
    if (run.failure.empty()) run.failure = error.what();
  }
}

void read_counts(StudyRun& run) {
  const auto json = run_json(run);
  run.increments = json.at("increments");
  run.iterations = json.at("iterations");
  run.cuts = json.at("cuts");
  run.megabytes = json.at("peak_megabytes");
}

double value_of(const StudyRun& run, const Quantity& q) {
  if (q.kind == Quantity::Kind::History) return history_value(run, q);
  return run_json(run).at("error").at(q.column + "_relative");
}

// The finest profile that there is, of the runs of one variant; of none if there is none.
Curve finest_profile(std::size_t quantity, const Quantity& q, std::span<StudyRun> runs) {
  Curve out;
  for (std::size_t i = runs.size(); i-- > 0 && out.place.empty();) {
    guarded(runs[i], [&] { out = profile_of(runs[i], q); });
    runs[i].is_reference[quantity] = !out.place.empty();
  }
  return out;
}

void read_profiles(std::size_t quantity, const Quantity& q, std::span<StudyRun> runs) {
  const Curve reference = q.reference.empty() ? finest_profile(quantity, q, runs) : curve_of(q.reference, q);
  if (reference.place.empty()) return;
  for (auto& run : runs)
    if (!run.is_reference[quantity]) guarded(run, [&] { run.value[quantity] = profile_value(run, q, reference); });
}

std::string list(const std::vector<std::string>& names) { return fmt::format("{}", fmt::join(names, ", ")); }

}  // namespace

void check_quantities(const scene::Study& study, const problem::Specification& s) {
  const std::vector<std::string> profile_columns{
      "gap",    "tn", "tt", "pressure", "slip", "partner_s", "partner_pressure", "opening", "jump_n",
      "jump_t", "s",  "X",  "Y",        "x",    "y"};
  const auto columns = results::history_columns(simulation::contents_of(s));
  for (std::size_t k = 0; k < study.quantities.size(); ++k) {
    const auto& q = study.quantities[k];
    const auto refuse = [&](const char* key, const std::string& problem) {
      throw InputError(q.at, fmt::format("quantity[{}].{}", k, key), problem);
    };
    const auto holds = [](const auto& names, const std::string& name) {
      return std::find(names.begin(), names.end(), name) != names.end();
    };
    if (q.kind == Quantity::Kind::History && !holds(columns, q.column))
      refuse("column", fmt::format("history.csv has no column '{}'; allowed: {}", q.column, list(columns)));
    if (q.kind == Quantity::Kind::Error && !s.exact)
      refuse("error", "the scene has no [exact] solution; allowed: a scene that has one");
    if (q.kind != Quantity::Kind::Profile) continue;
    if (!holds(profile_columns, q.column))
      refuse("column", fmt::format("no number in a crack's file; allowed: {}", list(profile_columns)));
    std::vector<std::string> cracks;
    for (const auto& crack : s.cracks) cracks.push_back(crack.name);
    if (!holds(cracks, q.crack))
      refuse("crack", fmt::format("the scene has no crack '{}'; allowed: {}", q.crack, list(cracks)));
    const auto& crack = *std::ranges::find(s.cracks, q.crack, &problem::CrackSpec::name);
    const auto other = q.side == "left" ? contact::NegativeSide::Right : contact::NegativeSide::Left;
    if (!q.side.empty() && crack.negative_side == other)
      refuse("side", fmt::format("the {} face of crack '{}' has no points; allowed: the face of its negative_side, or "
                                 "negative_side = \"both\"",
                                 q.side, q.crack));
    if (q.reference.empty()) continue;
    try {
      curve_of(q.reference, q);
    } catch (const std::runtime_error& error) {
      refuse("reference",
             fmt::format("{}; allowed: a CSV file with the columns {} and {}", error.what(), q.along, q.column));
    }
  }
}

void read_values(const scene::Study& study, std::span<StudyRun> runs) {
  for (auto& run : runs) {
    run.value.assign(study.quantities.size(), kNoValue);
    run.is_reference.assign(study.quantities.size(), false);
    guarded(run, [&] { read_counts(run); });
  }
  for (std::size_t k = 0; k < study.quantities.size(); ++k) {
    const Quantity& q = study.quantities[k];
    if (q.kind == Quantity::Kind::Profile)
      read_profiles(k, q, runs);
    else
      for (auto& run : runs) guarded(run, [&] { run.value[k] = value_of(run, q); });
  }
}

}  // namespace cleft::convergence
