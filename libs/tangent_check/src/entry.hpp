// Entries of a block matrix by their scalar place.
#pragma once

#include "cleft/assembly/block_matrix.hpp"

namespace cleft::tangent_check {

/// Entry (row, column), both counted in components; 0 where the pattern has none.
inline double entry(const assembly::BlockMatrix& matrix, Index row, Index column) {
  const auto place = matrix.find(row / 2, column / 2);
  return place.start == kNone ? 0.0 : matrix.values()[place.start + column % 2 * place.stride + row % 2];
}

}  // namespace cleft::tangent_check
