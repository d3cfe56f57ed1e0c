/// \file
/// A run: a scene solved increment by increment, with its files on disk.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "cleft/problem/specification.hpp"
#include "cleft/results/counts.hpp"
#include "cleft/results/critical_points.hpp"
#include "cleft/solve/stepping.hpp"

namespace cleft::simulation {

/// Where a run stands, for whoever shows it.
struct Progress {
  double load = 0.0;  ///< of the last converged increment
  int increment = 0;  ///< under way, from 1
  int iteration = 0;  ///< 0: the increment has just converged
  double residual = 0.0;
  long iterations = 0, cuts = 0;
  int contact_points = 0;
  double elapsed = 0.0;  ///< seconds
  double rest = 0.0;     ///< estimate, seconds
};

struct RunOptions {
  std::string directory;
  bool resume = false;
  int threads = 1;
  double last_load = 1.0;                          ///< the run ends with the first increment that reaches it
  std::function<void(const std::string&)> remark;  ///< hears the remarks on the scene, and what grows
  std::function<void(const Progress&)> observer;
  std::function<void(const solve::Step&)> step;  ///< hears each step that is recorded
  const std::atomic<bool>* stop = nullptr;       ///< set to end the run after the increment under way
};

struct RunResult : results::Counts {
  enum class End { Done, Failed, Stopped, NotWritten } end = End::Done;
  assembly::Failure failure;   ///< with End::Failed,
  std::string reason, advice;  ///< and in words (failure_words.hpp)
  std::string unwritten;       ///< with End::NotWritten: path and reason
  double load = 0.0;
  double last_load = 1.0;                        ///< that was asked for (RunOptions)
  long advances = 0;                             ///< of all tips
  std::vector<results::CriticalPoint> critical;  ///< in order, of runs with loading.control = "path"
  double newton_order = 0.0;                     ///< median over the increments that allow to tell; 0: none
  assembly::Energies energies;
  double overlap = 0.0;  ///< largest penetration so far over the size of the cut elements
  double seconds = 0.0;
  std::vector<std::pair<std::string, double>> phases;  ///< of the seconds, those of earlier parts not included
  double solver_seconds = 0.0;                         ///< all factorisations and solves
  double bulk_microseconds = 0.0;                      ///< assembly with tangent, per cell and iteration
  double contact_microseconds = 0.0;                   ///< search, law and tangent, per contact point and iteration
  double peak_megabytes = 0.0;
  std::vector<std::string> remarks;  ///< on what was solved; those known before are not among them
};

/// Solves the scene into the directory. Everything is validated before anything is written. Throws InputError on a bad
/// scene, std::runtime_error where the folder cannot be used or a checkpoint does not fit. A file that cannot be
/// written later ends the run after what its last checkpoint holds.
RunResult run(const problem::Specification& specification, const RunOptions& options);

}  // namespace cleft::simulation
