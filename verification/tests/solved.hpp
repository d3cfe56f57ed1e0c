// Runs a verification scene and reads its results.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>

#include "cleft/scene/files.hpp"
#include "cleft/scene/read.hpp"
#include "cleft/scene/run.hpp"

namespace cleft::verification {

struct Solved {
  scene::RunResult result;
  scene::CsvTable history;
  std::string directory;

  /// A column of history.csv at a load that the run hit.
  double at(const std::string& column, double load) const {
    const auto loads = history.column("load");
    for (std::size_t k = 0; k < loads.size(); ++k)
      if (std::fabs(loads[k] - load) < 1e-9) return history.column(column)[k];
    ADD_FAILURE() << "load " << load << " was not reached";
    return std::nan("");
  }
};

inline Solved solve(const std::string& scene, const std::vector<std::string>& overrides = {}) {
  const auto* info = testing::UnitTest::GetInstance()->current_test_info();
  std::string name = std::string(info->test_suite_name()) + "_" + info->name() + "_" + scene;
  for (const auto& o : overrides) name += "_" + o;
  for (char& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
  Solved out;
  out.directory = testing::TempDir() + "cleft_" + name;
  std::filesystem::remove_all(out.directory);
  scene::RunOptions options;
  options.directory = out.directory;
  out.result =
      scene::run(scene::read_scene(std::string(CLEFT_VERIFICATION) + "/scenes/" + scene + ".toml", overrides), options);
  EXPECT_EQ(out.result.end, scene::RunResult::End::Done) << assembly::describe(out.result.failure);
  out.history = scene::read_csv(out.directory + "/history.csv");
  return out;
}

/// Rows of a reference table; lines that start with # tell its provenance.
inline scene::CsvTable reference(const std::string& file) {
  scene::CsvTable table = scene::read_csv(std::string(CLEFT_VERIFICATION) + "/references/" + file);
  while (!table.header.empty() && table.header[0].starts_with("#")) {
    table.header = table.rows.front();
    table.rows.erase(table.rows.begin());
  }
  return table;
}

/// Rows of a crack's profile at one load, as columns by name.
inline std::vector<std::map<std::string, std::string>> profile(const Solved& run, const std::string& crack,
                                                               double load) {
  const auto table = scene::read_csv(run.directory + "/crack_" + crack + ".csv");
  std::vector<std::map<std::string, std::string>> rows;
  for (const auto& row : table.rows) {
    if (std::fabs(std::stod(row[0]) - load) > 1e-9) continue;
    auto& out = rows.emplace_back();
    for (std::size_t k = 0; k < row.size(); ++k) out[table.header[k]] = row[k];
  }
  return rows;
}

}  // namespace cleft::verification
