// What the runs of a study cost.
#pragma once

#include <span>
#include <vector>

#include "cleft/convergence/study.hpp"

namespace cleft::convergence {

/// How the costs of the runs of one variant grow, of those that reached their end.
std::vector<Cost> costs_of(std::span<const StudyRun> runs);

/// What relative errors of 1 % and 0.1 % cost, of a series whose errors are known; none of others.
std::vector<Work> work_of(const StudyResult& result, std::size_t series);

}  // namespace cleft::convergence
