// What run.json tells of a run.
#pragma once

#include <string>
#include <vector>

#include "cleft/growth/evolution.hpp"
#include "cleft/simulation/run.hpp"

namespace cleft::simulation {

/// The text of run.json. `total_seconds`: those of the run's earlier parts included. `notes`: the remarks before it.
std::string summary(const problem::Specification& specification, const growth::Evolution& evolution,
                    const RunResult& result, double total_seconds, const std::vector<std::string>& notes);

}  // namespace cleft::simulation
