/// \file
/// Compressed-column matrix of 2 x 2 blocks, one block row and column a vector unknown.
#pragma once

#include <array>
#include <span>
#include <utility>
#include <vector>

#include "cleft/support/types.hpp"

namespace cleft::assembly {

/// Structurally symmetric. The scalar matrix is an ordinary compressed-column one: column 2 j + b holds, for each block
/// (i, j), the rows 2 i and 2 i + 1.
class BlockMatrix {
 public:
  /// Where a block's entries stand: (a, b) is at value[start + b * stride + a].
  struct Place {
    Index start = kNone;
    Index stride = 0;
  };

  BlockMatrix() = default;

  /// A matrix of `size` blocks square with the given blocks (row, column; any order, repeated ones merged) and the
  /// diagonal.
  BlockMatrix(Index size, const std::vector<std::array<Index, 2>>& blocks);

  Index size() const { return size_; }
  Index rows() const { return 2 * size_; }
  Index nonzeros() const { return static_cast<Index>(values_.size()); }

  /// The place of block (row, column); start is kNone where the pattern has none.
  Place find(Index row, Index column) const {
    const Index blocks = starts_[column + 1] - starts_[column];
    const Index* const begin = rows_.data() + starts_[column];
    const Index* at = begin;
    for (Index left = blocks; left > 1;) {  // without branches, which nobody could predict
      const Index half = left / 2;
      at += half * static_cast<Index>(at[half - 1] < row);
      left -= half;
    }
    if (*at != row) return {};
    return {4 * starts_[column] + 2 * static_cast<Index>(at - begin), 2 * blocks};
  }

  /// Entry (row, column), both counted in components; 0 where the pattern has none.
  double entry(Index row, Index column) const {
    const Place place = find(row / 2, column / 2);
    return place.start == kNone ? 0.0 : values_[place.start + column % 2 * place.stride + row % 2];
  }

  void add(const Place& place, const Mat2& block) {
    double* v = values_.data() + place.start;
    v[0] += block(0, 0);
    v[1] += block(1, 0);
    v[place.stride] += block(0, 1);
    v[place.stride + 1] += block(1, 1);
  }
  void set_zero();

  /// Block rows present in block column `column`, ascending.
  std::span<const Index> block_rows(Index column) const;

  std::span<const Index> scalar_starts() const { return scalar_starts_; }
  std::span<const Index> scalar_rows() const { return scalar_rows_; }
  std::span<const double> values() const { return values_; }
  std::span<double> values() { return values_; }

  /// y = A x
  VecX multiply(const VecX& x) const;

 private:
  Index size_ = 0;
  std::vector<Index> starts_, rows_;  // blocks
  std::vector<Index> scalar_starts_, scalar_rows_;
  std::vector<double> values_;
};

}  // namespace cleft::assembly
