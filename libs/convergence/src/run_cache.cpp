#include "cleft/convergence/run_cache.hpp"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "cleft/results/checkpoint.hpp"
#include "cleft/scene/json.hpp"
#include "cleft/support/files.hpp"

namespace cleft::convergence {
namespace {

const char* const kSeal = "/study_seal";
const char* const kTimings = "/timings.json";

// Of names and bytes of the files that a study reads.
std::string fingerprint(const std::string& folder) {
  std::set<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (const auto ending = entry.path().extension(); ending == ".csv" || ending == ".json")
      files.insert(entry.path().filename().string());
  std::string all;
  for (const auto& file : files) all += file + " " + scene::hash_of(read_bytes(folder + "/" + file)) + "\n";
  return all;
}

double median(std::vector<double> values) {
  const std::size_t half = values.size() / 2;
  std::sort(values.begin(), values.end());
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

}  // namespace

void seal(const std::string& folder) { write_atomically(folder + kSeal, fingerprint(folder)); }

bool is_sealed(const std::string& folder) {
  try {
    return std::filesystem::exists(folder + kSeal) && read_bytes(folder + kSeal) == fingerprint(folder);
  } catch (const std::runtime_error&) {
    return false;
  }
}

bool is_resumable(const std::string& folder) {
  const std::string path = folder + "/checkpoint";
  try {
    if (std::filesystem::exists(folder + kSeal) || !std::filesystem::exists(path)) return false;
    results::checkpoint_from(read_bytes(path), path);
    return true;
  } catch (const std::runtime_error&) {
    return false;
  }
}

Timing timing_of(const std::string& folder, int jobs) {
  const auto seconds = nlohmann::json::parse(read_bytes(folder + "/run.json")).at("seconds");
  Timing out{jobs, seconds.at("total"), seconds};
  out.phases.erase("total");
  return out;
}

std::vector<Timing> read_timings(const std::string& folder) {
  std::vector<Timing> out;
  if (!std::filesystem::exists(folder + kTimings)) return out;
  for (const auto& each : nlohmann::json::parse(read_bytes(folder + kTimings)))
    out.push_back({each.at("jobs"), each.at("seconds"), each.at("phases")});
  return out;
}

void write_timings(const std::string& folder, const std::vector<Timing>& timings) {
  auto all = nlohmann::json::array();
  for (const auto& t : timings) all.push_back({{"jobs", t.jobs}, {"seconds", t.seconds}, {"phases", t.phases}});
  write_atomically(folder + kTimings, all.dump(2) + "\n");
}

Timing median(const std::vector<Timing>& all) {
  std::vector<double> seconds;
  std::map<std::string, std::vector<double>> phases;
  for (const auto& timing : all) {
    seconds.push_back(timing.seconds);
    for (const auto& [phase, spent] : timing.phases) phases[phase].push_back(spent);
  }
  Timing out{all.front().jobs, median(seconds), {}};
  for (const auto& [phase, spent] : phases) out.phases[phase] = median(spent);
  return out;
}

}  // namespace cleft::convergence
