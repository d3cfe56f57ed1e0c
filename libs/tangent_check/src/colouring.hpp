// Columns that may be varied at the same time.
#pragma once

#include <vector>

#include "cleft/assembly/block_matrix.hpp"

namespace cleft::tangent_check {

/// Divides the block columns into groups in which no two have a row in common.
std::vector<std::vector<Index>> colour_columns(const assembly::BlockMatrix& matrix);

}  // namespace cleft::tangent_check
