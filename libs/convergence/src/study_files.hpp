// The files of a study.
#pragma once

#include "cleft/convergence/study.hpp"

namespace cleft::convergence {

/// study.csv, fits.csv, costs.csv, convergence.svg (relative error against h) and cost.svg (seconds against relative
/// error). Where no limit is determined errors are nan, and the figures show the difference from the finest mesh.
void write_study(const scene::Study& study, const StudyResult& result, const std::string& directory);

}  // namespace cleft::convergence
