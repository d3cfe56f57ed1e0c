#include "cleft/assembly/block_matrix.hpp"

#include <algorithm>

namespace cleft::assembly {

BlockMatrix::BlockMatrix(Index size, const std::vector<std::array<Index, 2>>& blocks) : size_(size) {
  // bucket the rows of each column, then sort and merge the few in every bucket
  std::vector<Index> bucket_start(size + 1, 0);
  for (const auto& [row, column] : blocks) ++bucket_start[column + 1];
  for (Index j = 0; j < size; ++j) bucket_start[j + 1] += bucket_start[j] + 1;  // and the diagonal
  std::vector<Index> bucket(bucket_start[size]), fill(bucket_start.begin(), bucket_start.end() - 1);
  for (Index j = 0; j < size; ++j) bucket[fill[j]++] = j;
  for (const auto& [row, column] : blocks) bucket[fill[column]++] = row;

  starts_.assign(1, 0);
  starts_.reserve(size + 1);
  for (Index j = 0; j < size; ++j) {
    const auto begin = bucket.begin() + bucket_start[j], end = bucket.begin() + bucket_start[j + 1];
    std::sort(begin, end);
    rows_.insert(rows_.end(), begin, std::unique(begin, end));
    starts_.push_back(static_cast<Index>(rows_.size()));
  }

  scalar_starts_.reserve(2 * size + 1);
  scalar_starts_.push_back(0);
  scalar_rows_.reserve(4 * rows_.size());
  for (Index j = 0; j < size; ++j)
    for (int b = 0; b < 2; ++b) {
      for (Index k = starts_[j]; k < starts_[j + 1]; ++k) {
        scalar_rows_.push_back(2 * rows_[k]);
        scalar_rows_.push_back(2 * rows_[k] + 1);
      }
      scalar_starts_.push_back(static_cast<Index>(scalar_rows_.size()));
    }
  values_.assign(scalar_rows_.size(), 0.0);
}

void BlockMatrix::set_zero() { std::fill(values_.begin(), values_.end(), 0.0); }

std::span<const Index> BlockMatrix::block_rows(Index column) const {
  return std::span(rows_).subspan(starts_[column], starts_[column + 1] - starts_[column]);
}

VecX BlockMatrix::multiply(const VecX& x) const {
  VecX y = VecX::Zero(rows());
  for (Index j = 0; j < rows(); ++j)
    for (Index k = scalar_starts_[j]; k < scalar_starts_[j + 1]; ++k) y[scalar_rows_[k]] += values_[k] * x[j];
  return y;
}

}  // namespace cleft::assembly
