/// \file
/// The files of a run.
#pragma once

#include <map>
#include <optional>

#include "cleft/problem/specification.hpp"
#include "cleft/results/checkpoint.hpp"
#include "cleft/results/files.hpp"
#include "cleft/results/profile.hpp"

namespace cleft::results {

/// The columns of a scene's history.csv.
std::vector<std::string> history_columns(const problem::Specification& scene);

class Results {
 public:
  /// Starts the files of a fresh run, or goes on with those that a checkpoint speaks of.
  Results(const problem::Specification& scene, std::string directory, const Checkpoint* resumed);

  void add_step(const growth::Step& step, const solve::LoadStepper& stepper);
  void add_fields(const growth::Step& step, const solve::LoadStepper& stepper);

  std::map<std::string, std::uint64_t> log_bytes() const;
  const std::vector<PvdEntry>& outputs() const { return outputs_; }
  std::string path(const std::string& file) const { return directory_ + "/" + file; }

 private:
  void add_advances(const growth::Step& step, const assembly::Model& model);
  void open(const std::string& file, const std::string& header, const Checkpoint* resumed);

  const problem::Specification& scene_;
  std::string directory_;
  std::map<std::string, LineLog> logs_;
  std::vector<PvdEntry> outputs_;
};

}  // namespace cleft::results
