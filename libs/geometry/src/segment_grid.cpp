#include "cleft/geometry/segment_grid.hpp"

#include <bit>
#include <cassert>
#include <cmath>

namespace cleft::geometry {

void SegmentGrid::build(std::span<const Vec2> starts, std::span<const Vec2> ends) {
  assert(starts.size() == ends.size());
  count_ = static_cast<Index>(starts.size());
  items_.clear();
  if (count_ == 0) return;

  low_ = high_ = starts[0];
  double sum_of_squares = 0.0;
  for (std::size_t k = 0; k < starts.size(); ++k) {
    low_ = low_.cwiseMin(starts[k]).cwiseMin(ends[k]);
    high_ = high_.cwiseMax(starts[k]).cwiseMax(ends[k]);
    sum_of_squares += (ends[k] - starts[k]).squaredNorm();
  }
  // With cells of the root mean square length the boxes of n segments cover O(n) cells in total, whatever their
  // lengths. Points, or segments far smaller than their distances, get cells of which about one in eight is occupied.
  const double n = count_;
  const double spread = (high_ - low_).maxCoeff() / std::sqrt(8.0 * n);
  const bool sparse = sum_of_squares / n < 1e-4 * spread * spread;
  const double cell = sparse ? spread : std::sqrt(sum_of_squares / n);
  per_length_ = cell > 0.0 && std::isfinite(1.0 / cell) ? 1.0 / cell : 0.0;

  mask_ = std::bit_ceil(2 * static_cast<std::uint64_t>(count_)) - 1;
  first_.assign(static_cast<std::size_t>(mask_) + 2, 0);
  const auto for_each_bucket = [&](auto&& act) {
    for (std::size_t k = 0; k < starts.size(); ++k) {
      const Cells cells = cells_of(starts[k].cwiseMin(ends[k]), starts[k].cwiseMax(ends[k]));
      for (std::int64_t j = cells.low[1]; j <= cells.high[1]; ++j) {
        for (std::int64_t i = cells.low[0]; i <= cells.high[0]; ++i) act(bucket_of(i, j), static_cast<Index>(k));
      }
    }
  };
  for_each_bucket([&](std::size_t bucket, Index) { ++first_[bucket + 1]; });
  for (std::size_t b = 0; b + 1 < first_.size(); ++b) first_[b + 1] += first_[b];
  items_.resize(static_cast<std::size_t>(first_.back()));
  for_each_bucket([&](std::size_t bucket, Index k) { items_[static_cast<std::size_t>(first_[bucket]++)] = k; });
  // Filling has moved every start to the next bucket's.
  for (std::size_t b = first_.size() - 1; b > 0; --b) first_[b] = first_[b - 1];
  first_[0] = 0;
}

}  // namespace cleft::geometry
