// The figures of a study.
#pragma once

#include "cleft/convergence/study.hpp"

namespace cleft::convergence {

/// convergence.svg (relative error over h, with the fitted powers as lines and triangles of their slopes) and cost.svg
/// (relative error over seconds). Where no limit is determined the figures show the difference from the finest mesh.
void draw_study(const scene::Study& study, const StudyResult& result, const std::string& directory);

}  // namespace cleft::convergence
