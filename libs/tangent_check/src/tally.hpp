// Sums up entries in a report.
#pragma once

#include "cleft/tangent_check/tangent.hpp"
#include "difference.hpp"

namespace cleft::tangent_check {

/// Why a piece is listed some of whose entries are left out.
inline constexpr const char* kUnclear = "two sizes of the step disagree";

/// Adds an entry, complete but for its difference, to its block; false if the difference is too uncertain to judge it.
bool count(TangentBlock& block, TangentEntry entry, const Quotient& difference, double tolerance);

}  // namespace cleft::tangent_check
