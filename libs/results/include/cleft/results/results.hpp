/// \file
/// The files of a run.
#pragma once

#include <map>
#include <memory>

#include "cleft/results/checkpoint.hpp"
#include "cleft/results/contents.hpp"
#include "cleft/results/crack_profile.hpp"
#include "cleft/support/files.hpp"

namespace cleft::results {

class Results {
 public:
  /// Starts the files of a fresh run, or goes on with those that a checkpoint speaks of.
  Results(Contents contents, std::string directory, const Checkpoint* resumed);
  ~Results();

  /// Adds the failed attempts at a step to newton.csv; what a step shows to history.csv, newton.csv and growth.csv; its
  /// fields to files of their own and to those of the cracks. All throw std::runtime_error with path and reason.
  void add_failed_attempts(int step, const std::vector<solve::FailedAttempt>& attempts);
  void add_step(const growth::Step& step, const solve::LoadStepper& stepper);
  void add_fields(const growth::Step& step, const solve::LoadStepper& stepper);

  std::map<std::string, std::uint64_t> log_bytes() const;
  const std::vector<PvdEntry>& outputs() const { return outputs_; }
  std::string path(const std::string& file) const { return directory_ + "/" + file; }

 private:
  struct Tables;
  void add_iterations(const growth::Step& step);
  void add_advances(const growth::Step& step, const assembly::Model& model);
  void add_profiles(const growth::Step& step, double load, const std::vector<ProfilePoint>& points);
  void open(const std::string& file, const std::string& header, const Checkpoint* resumed);

  Contents contents_;
  std::unique_ptr<const Tables> tables_;
  std::string directory_;
  std::map<std::string, LineLog> logs_;
  std::vector<PvdEntry> outputs_;
  int failed_attempts_ = 0;  // at the step to come
};

}  // namespace cleft::results
