/// \file
/// Limit points and bifurcations of a path, from its history.
#pragma once

#include <vector>

#include "cleft/results/files.hpp"
#include "cleft/results/incidents.hpp"

namespace cleft::results {

/// Where the load turns, and where the determinant of the tangent matrix changes its sign though the load goes on; at
/// rest it is positive. A change of sign from one row before a turn to two rows after it belongs to the turn, and two
/// changes in one increment are not seen. `history` has the columns `step`, `load` and `determinant_sign`; rows whose
/// sign is unknown are passed over.
std::vector<CriticalPoint> critical_points(const CsvTable& history);

const char* name_of(CriticalPoint::Kind kind);

}  // namespace cleft::results
