// Runs of a study, by the program itself.
#pragma once

#include "study_plan.hpp"

namespace cleft::convergence {

/// Runs what is not kept from before, several at a time, times it as often as is asked for, and notes on each run what
/// kept it from its end.
void run_all(const scene::Study& study, const StudyOptions& options, Plan& plan);

}  // namespace cleft::convergence
