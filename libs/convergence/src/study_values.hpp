// What the runs of a study left, as numbers.
#pragma once

#include <span>

#include "cleft/convergence/study.hpp"
#include "cleft/problem/specification.hpp"

namespace cleft::convergence {

/// Throws InputError where a quantity asks for what the scene does not have.
void check_quantities(const scene::Study& study, const problem::Specification& scene);

/// Reads seconds (of the phases, too), counts and memory out of run.json.
void read_counts(StudyRun& run);

/// Fills in the value of every quantity of the runs of one variant, coarsest mesh first.
void read_values(const scene::Study& study, std::span<StudyRun> runs);

}  // namespace cleft::convergence
