// Runs into folders, whole and in parts.
#pragma once

#include <atomic>

#include "cleft/simulation/run.hpp"

namespace cleft::simulation {

inline RunOptions into(const std::string& directory) {
  RunOptions options;
  options.directory = directory;
  return options;
}

/// Stops after every step and resumes until there is another end than having been stopped.
inline RunResult run_step_by_step(const problem::Specification& scene, const std::string& directory) {
  std::atomic<bool> stop = false;
  RunOptions options = into(directory);
  options.stop = &stop;
  options.observer = [&](const Progress& p) { stop = p.iteration == 0; };
  RunResult result;
  do {
    stop = false;
    result = run(scene, options);
    options.resume = true;
  } while (result.end == RunResult::End::Stopped);
  return result;
}

}  // namespace cleft::simulation
