// Limit points and bifurcations of a path, from its history.
#pragma once

#include <vector>

#include "cleft/scene/files.hpp"
#include "cleft/scene/run.hpp"

namespace cleft::scene {

/// Where the load turns, and where the determinant of the tangent matrix changes its sign though the load goes on: the
/// load there is where the least pivot, linear between two rows, vanishes. `history` has the columns `step`, `load`,
/// `determinant_sign` and `least_pivot`; rows whose sign is unknown are passed over.
std::vector<CriticalPoint> critical_points(const CsvTable& history);

const char* name_of(CriticalPoint::Kind kind);

}  // namespace cleft::scene
