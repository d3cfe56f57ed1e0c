// What a run tells when it has ended.
#pragma once

#include <string>

#include "cleft/simulation/run.hpp"

namespace cleft::tools {

std::string duration(double seconds);

/// On stdout, in 80 columns: how far, how well, how long, where the results are, what an expert would warn of and look
/// at next.
void print_summary(const problem::Specification& scene, const simulation::RunResult& result,
                   const std::string& directory);

}  // namespace cleft::tools
