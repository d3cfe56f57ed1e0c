// Runs a verification scene and reads its results.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "cleft/problem/build.hpp"
#include "cleft/scene/read.hpp"
#include "cleft/simulation/run.hpp"
#include "cleft/support/files.hpp"

namespace cleft::verification {

/// A verification scene with overrides.
problem::Specification scene_of(const std::string& name, const std::vector<std::string>& overrides = {});

/// A row of a table, by the names of its columns.
using Row = std::map<std::string, std::string>;
inline double number(const Row& row, const std::string& column) { return std::stod(row.at(column)); }

struct Solved {
  simulation::RunResult result;
  CsvTable history;
  std::shared_ptr<const std::string> directory;  ///< vanishes with the last copy

  /// A column of history.csv at a load that the run hit.
  double at(const std::string& column, double load) const;

  /// The points of a crack's profile at one load.
  std::vector<Row> profile(const std::string& crack, double load) const;
};

/// Runs a verification scene to its end; the running test fails if it does not get there.
Solved solve(const std::string& scene, const std::vector<std::string>& overrides = {});
Solved solve(const problem::Specification& scene);

/// A scene solved in memory, with nothing written; the running test fails if it does not get to its end.
struct SolvedModel {
  explicit SolvedModel(const problem::Specification& scene);
  SolvedModel(const SolvedModel&) = delete;
  SolvedModel& operator=(const SolvedModel&) = delete;

  assembly::Model model;
  solve::LoadStepper stepper;
};

/// Rows of a reference table; lines that start with # tell its provenance.
CsvTable reference(const std::string& file);

/// The value that is farthest from `from`; `from` if there is none.
double farthest(const std::vector<double>& values, double from);

}  // namespace cleft::verification
