#include "solved.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>

namespace cleft::verification {
namespace {

std::shared_ptr<const std::string> scratch_directory() {
  static int count = 0;
  const std::string path =
      testing::TempDir() + "cleft_verification_" + std::to_string(getpid()) + "_" + std::to_string(++count);
  std::filesystem::remove_all(path);
  return {new std::string(path), [](const std::string* name) {
            std::error_code ignored;
            std::filesystem::remove_all(*name, ignored);
            delete name;
          }};
}

}  // namespace

problem::Specification scene_of(const std::string& name, const std::vector<std::string>& overrides) {
  return scene::read_scene(std::string(CLEFT_VERIFICATION) + "/scenes/" + name + ".toml", overrides);
}

Solved solve(const std::string& scene, const std::vector<std::string>& overrides) {
  return solve(scene_of(scene, overrides));
}

Solved solve(const problem::Specification& scene) {
  Solved out;
  out.directory = scratch_directory();
  simulation::RunOptions options;
  options.directory = *out.directory;
  out.result = simulation::run(scene, options);
  EXPECT_EQ(out.result.end, simulation::RunResult::End::Done) << out.result.reason;
  out.history = read_csv(*out.directory + "/history.csv");
  return out;
}

SolvedModel::SolvedModel(const problem::Specification& scene)
    : model(problem::build_model(scene)), stepper(model, problem::step_controls(scene)) {
  while (!stepper.done()) {
    const auto outcome = stepper.advance();
    if (const auto* failure = std::get_if<assembly::Failure>(&outcome)) {
      ADD_FAILURE() << name_of(failure->kind);
      return;
    }
  }
}

double Solved::at(const std::string& column, double load) const {
  const auto loads = history.column("load");
  for (std::size_t k = loads.size(); k-- > 0;)
    if (std::fabs(loads[k] - load) < 1e-9) return history.column(column)[k];
  ADD_FAILURE() << "load " << load << " was not reached";
  return std::nan("");
}

std::vector<Row> Solved::profile(const std::string& crack, double load) const {
  const auto table = read_csv(*directory + "/crack_" + crack + ".csv");
  std::vector<Row> rows;
  for (const auto& cells : table.rows) {
    if (std::fabs(std::stod(cells[0]) - load) > 1e-9) continue;
    Row& row = rows.emplace_back();
    for (std::size_t k = 0; k < cells.size(); ++k) row[table.header[k]] = cells[k];
  }
  EXPECT_FALSE(rows.empty()) << "crack " << crack << " has no points at load " << load;
  return rows;
}

CsvTable reference(const std::string& file) {
  return read_csv(std::string(CLEFT_VERIFICATION) + "/references/" + file);
}

double farthest(const std::vector<double>& values, double from) {
  double out = from;
  for (const double value : values)
    if (!(std::fabs(value - from) <= std::fabs(out - from))) out = value;
  return out;
}

}  // namespace cleft::verification
