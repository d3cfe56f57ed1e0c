#include "run_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <stdexcept>

namespace cleft::report {
namespace {

namespace fs = std::filesystem;

void read_if_there(const std::string& path, std::optional<CsvTable>& table) {
  if (fs::exists(path)) table = read_csv(path);
}

// Profiles along cracks are those that begin as a run writes them: other files may lie in the folder.
std::vector<Run::Crack> cracks_in(const std::string& directory) {
  const std::string prefix = "crack_", ending = ".csv";
  std::vector<Run::Crack> out;
  for (const auto& entry : fs::directory_iterator(directory)) {
    const std::string file = entry.path().filename();
    if (!file.starts_with(prefix) || !file.ends_with(ending)) continue;
    auto table = read_csv(entry.path());
    const bool ours =
        table.header.size() >= 3 && table.header[0] == "load" && table.header[1] == "side" && table.header[2] == "s";
    if (!ours || table.rows.empty()) continue;
    out.push_back({file.substr(prefix.size(), file.size() - prefix.size() - ending.size()), std::move(table)});
  }
  std::ranges::sort(out, {}, &Run::Crack::name);
  return out;
}

nlohmann::ordered_json info_in(const std::string& directory) {
  const std::string path = directory + "/run.json";
  if (!fs::exists(path)) return {};
  try {
    return nlohmann::ordered_json::parse(read_bytes(path));
  } catch (const nlohmann::ordered_json::exception& error) {
    throw std::runtime_error(path + ": " + error.what());
  }
}

Run read_run(const std::string& directory) {
  Run run;
  run.directory = directory;
  const std::string history = directory + "/history.csv";
  if (!fs::is_directory(directory)) throw std::runtime_error(directory + ": there is no such folder");
  if (!fs::exists(history))
    throw std::runtime_error(directory + ": not the folder of a run: it has no history.csv; allowed: what `cleft run " +
                             "SCENE.toml -o FOLDER` leaves");
  run.history = read_csv(history);
  column_of(run.history, "load", history);
  column_of(run.history, "step", history);
  read_if_there(directory + "/newton.csv", run.newton);
  read_if_there(directory + "/growth.csv", run.growth);
  run.cracks = cracks_in(directory);
  run.info = info_in(directory);
  read_shapes(run);
  return run;
}

// The last `count` parts of a path.
std::string end_of(const std::string& directory, std::size_t count) {
  fs::path path = fs::path(directory).lexically_normal(), out;
  if (!path.has_filename()) path = path.parent_path();
  for (; count > 0 && path.has_filename(); --count, path = path.parent_path())
    out = out.empty() ? path.filename() : path.filename() / out;
  return out.empty() ? directory : out.string();
}

// As much of the ends of the paths as tells the runs apart.
void label(std::vector<Run>& runs) {
  constexpr std::size_t kMostParts = 20;
  for (std::size_t count = 1; count <= kMostParts; ++count) {
    std::set<std::string> labels;
    for (auto& run : runs) labels.insert(run.label = end_of(run.directory, count));
    if (labels.size() == runs.size()) return;
  }
}

// Runs that are compared have one colour bar a field.
void share_ranges(std::vector<Run>& runs) {
  std::map<std::string, Range> shared;
  const auto visit = [&](const auto& visitor) {
    for (auto& run : runs)
      for (std::size_t k = 0; k < run.fields.size(); ++k) visitor(run.fields[k].name, run.ranges[k]);
  };
  visit([&](const char* name, const Range& range) {
    Range& all = shared.emplace(name, range).first->second;
    all = {std::min(all.least, range.least), std::max(all.most, range.most), std::min(all.low, range.low),
           std::max(all.high, range.high)};
  });
  visit([&](const char* name, Range& range) { range = shared.at(name); });
}

}  // namespace

std::string Run::title() const {
  if (!info.is_object() || !info.contains("scene")) return "";
  return info["scene"].value("title", "");
}

std::vector<double> Run::column(const std::string& name) const {
  if (std::ranges::find(history.header, name) == history.header.end()) return {};
  return column_of(history, name, directory + "/history.csv");
}

std::vector<double> column_of(const CsvTable& table, const std::string& name, const std::string& path) {
  try {
    return table.column(name);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(path + ": " + error.what());
  }
}

std::vector<Run> read_runs(const std::vector<std::string>& directories) {
  std::vector<Run> runs;
  for (const auto& directory : directories) runs.push_back(read_run(directory));
  label(runs);
  share_ranges(runs);
  return runs;
}

}  // namespace cleft::report
