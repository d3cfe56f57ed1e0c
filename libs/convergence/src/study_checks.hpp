// Orders and limits that a study asks for.
#pragma once

#include "cleft/convergence/study.hpp"

namespace cleft::convergence {

/// Adds to `missed` what does not hold and to `undecided` what the data do not tell: an order or limit holds where its
/// 95 % interval lies within what is asked for, and does not where the interval lies outside.
void check_series(const scene::Quantity& quantity, const Series& series, StudyResult& result);

}  // namespace cleft::convergence
