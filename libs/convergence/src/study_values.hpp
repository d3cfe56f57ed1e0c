// What the runs of a study left, as numbers.
#pragma once

#include <span>

#include "cleft/convergence/study.hpp"
#include "cleft/problem/specification.hpp"

namespace cleft::convergence {

/// Throws InputError where a quantity asks for what the scene does not have.
void check_quantities(const scene::Study& study, const problem::Specification& scene);

/// Reads counts and memory of a run that has not failed, and fills in its quantities' values. What cannot be read is
/// the run's failure. Of a run that has failed, what it has left counts as far as it goes. `runs` are those of one
/// variant, coarsest first; their finest profiles are what the others are compared with.
void read_values(const scene::Study& study, std::span<StudyRun> runs);

}  // namespace cleft::convergence
