/// \file
/// Limit points and bifurcations of a path, from its history.
#pragma once

#include <vector>

#include "cleft/support/files.hpp"

namespace cleft::results {

/// Where the path turns, or where the determinant changes its sign and another one may branch off.
struct CriticalPoint {
  enum class Kind { Maximum, Minimum, Bifurcation } kind;
  double load = 0.0;    ///< of the increment nearest to a limit point, or of the first beyond a bifurcation
  double before = 0.0;  ///< of the one before that
  long step = 0;        ///< its row of history.csv
};

/// Where the load turns, and where the determinant of the tangent matrix changes its sign though the load goes on; at
/// rest it is positive. A change of sign from one row before a turn to two rows after it belongs to the turn, and two
/// changes in one increment are not seen. `history` has the columns `step`, `load` and `determinant_sign`; rows whose
/// sign is unknown are passed over.
std::vector<CriticalPoint> critical_points(const CsvTable& history);

const char* name_of(CriticalPoint::Kind kind);

}  // namespace cleft::results
