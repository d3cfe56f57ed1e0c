// The files of a study.
#pragma once

#include "cleft/convergence/study.hpp"

namespace cleft::convergence {

/// runs.csv, study.csv, fits.csv, costs.csv and work.csv, and of sequences the figures. Where no limit is determined
/// errors are nan.
void write_study(const scene::Study& study, const StudyResult& result, const std::string& directory);

}  // namespace cleft::convergence
