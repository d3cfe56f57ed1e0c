#include "cleft/geometry/segment_grid.hpp"

#include <algorithm>
#include <cmath>

namespace cleft::geometry {

void SegmentGrid::build(std::span<const Vec2> starts, std::span<const Vec2> ends) {
  nx_ = ny_ = 0;
  if (starts.empty()) return;
  Vec2 low = starts[0], high = starts[0];
  double length = 0.0;
  for (std::size_t k = 0; k < starts.size(); ++k) {
    low = low.cwiseMin(starts[k]).cwiseMin(ends[k]);
    high = high.cwiseMax(starts[k]).cwiseMax(ends[k]);
    length += (ends[k] - starts[k]).norm();
  }
  // Cells about as large as a segment, but no more cells than a few per segment.
  const auto count = static_cast<double>(starts.size());
  const Vec2 extent = high - low;
  const double least = std::sqrt(extent.x() * extent.y() / (4.0 * count)) + extent.maxCoeff() / (4.0 * count);
  cell_ = std::max(length / count, least);
  if (!(cell_ > 0.0) || !std::isfinite(cell_)) cell_ = 1.0;
  origin_ = low;
  nx_ = 1 + static_cast<int>(extent.x() / cell_);
  ny_ = 1 + static_cast<int>(extent.y() / cell_);

  first_.assign(static_cast<std::size_t>(nx_) * ny_ + 1, 0);
  const auto each = [&](auto&& put) {
    for (std::size_t k = 0; k < starts.size(); ++k) {
      const Range range = cells_of(starts[k].cwiseMin(ends[k]), starts[k].cwiseMax(ends[k]));
      for (int y = range.y0; y <= range.y1; ++y)
        for (int x = range.x0; x <= range.x1; ++x) put(y * nx_ + x, static_cast<Index>(k));
    }
  };
  each([&](int cell, Index) { ++first_[cell + 1]; });
  for (std::size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
  items_.resize(first_.back());
  fill_.assign(first_.begin(), first_.end() - 1);
  each([&](int cell, Index k) { items_[fill_[cell]++] = k; });
}

SegmentGrid::Range SegmentGrid::cells_of(const Vec2& low, const Vec2& high) const {
  const auto place = [&](double x, int count) {
    return static_cast<int>(std::clamp(std::floor(x / cell_), 0.0, static_cast<double>(count - 1)));
  };
  return {place(low.x() - origin_.x(), nx_), place(high.x() - origin_.x(), nx_), place(low.y() - origin_.y(), ny_),
          place(high.y() - origin_.y(), ny_)};
}

}  // namespace cleft::geometry
