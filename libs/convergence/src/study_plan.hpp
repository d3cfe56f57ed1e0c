// What a study asks to be run.
#pragma once

#include "cleft/convergence/study.hpp"
#include "cleft/problem/specification.hpp"

namespace cleft::convergence {

/// One run that is asked for: the scene and how the program is told of it.
struct Task {
  problem::Specification scene;
  std::vector<std::string> overrides;
  double last_load = 1.0;  ///< at which the study looks
};

struct Plan {
  std::vector<Task> tasks;
  std::vector<StudyRun> runs;  ///< of the tasks: variant by variant, coarsest first
};

/// What messages call a run.
std::string title_of(const StudyRun& run);

/// Reads every scene and builds every mesh, so that what is wrong is said before anything runs. Throws InputError at
/// the place of the study that asks for it.
Plan plan_of(const scene::Study& study, const StudyOptions& options);

}  // namespace cleft::convergence
