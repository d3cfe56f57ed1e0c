// Loads that increments end at.
#pragma once

#include "cleft/solve/stepping.hpp"

namespace cleft::solve {

/// Two loads are the same if they differ by less.
constexpr double kLoadResolution = 1e-12;

/// A planned load k/steps gives way to an output or a kink that is nearer than this part of 1/steps.
constexpr double kGivesWay = 1e-2;

/// Whether one of the loads is no farther from `load` than `within`.
bool has_near(const std::vector<double>& loads, double load, double within);

/// Whether an amplitude turns at a load.
bool turns_at(const StepControls& controls, double load);

/// Loads that are hit whatever the size of the increments: all outputs, and all kinks but those that are outputs up to
/// the rounding of six decimals. Ascending.
std::vector<double> marks_of(const StepControls& controls);

/// The marks, load 1 and, unless the size of the increments is free, the planned loads k/steps that no mark stands for.
/// Two planned neighbours are therefore at most (1 + 2 kGivesWay) / steps apart. Ascending.
std::vector<double> targets_of(const StepControls& controls, const std::vector<double>& marks);

/// The first of the loads, which ascend, beyond `load`; 1 if there is none.
double first_beyond(const std::vector<double>& loads, double load);

/// The length of the interval between two of the loads, or load 0, that `load` lies in or begins.
double interval_around(const std::vector<double>& loads, double load);

}  // namespace cleft::solve
