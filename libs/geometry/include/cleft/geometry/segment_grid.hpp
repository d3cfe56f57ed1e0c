/// \file
/// Spatial search among line segments that move.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "cleft/support/types.hpp"

namespace cleft::geometry {

/// A hashed uniform grid over segments of the plane: however far apart they are, memory is O(segments). Rebuilding
/// reuses its memory. Building is O(segments), a query touches only the cells that the box of the query segment covers.
class SegmentGrid {
 public:
  /// Segment k runs from `starts[k]` to `ends[k]`, metres. Both spans have one length; empty is allowed, and so are
  /// segments of no length.
  void build(std::span<const Vec2> starts, std::span<const Vec2> ends);

  /// Calls `visit(k)` at least once for every segment k whose bounding box meets the bounding box of a-b; others may
  /// be visited too, and one more than once.
  template <class Visit>
  void near(const Vec2& a, const Vec2& b, Visit&& visit) const;

 private:
  struct Cells {
    std::array<std::int64_t, 2> low, high;
    std::int64_t count() const { return (high[0] - low[0] + 1) * (high[1] - low[1] + 1); }
  };

  std::int64_t cell_of(double offset) const {
    const double position = offset * per_length_;
    if (position >= kFarthest) return static_cast<std::int64_t>(kFarthest);
    return position > 0.0 ? static_cast<std::int64_t>(position) : std::int64_t{0};  // not a number counts as 0
  }
  Cells cells_of(const Vec2& low, const Vec2& high) const {
    return {{cell_of(low.x() - low_.x()), cell_of(low.y() - low_.y())},
            {cell_of(high.x() - low_.x()), cell_of(high.y() - low_.y())}};
  }
  std::size_t bucket_of(std::int64_t i, std::int64_t j) const {
    const auto mixed =
        (static_cast<std::uint64_t>(i) * 0x9e3779b97f4a7c15U) ^ (static_cast<std::uint64_t>(j) * 0xc2b2ae3d27d4eb4fU);
    return static_cast<std::size_t>((mixed ^ (mixed >> 32U)) & mask_);
  }

  static constexpr double kFarthest = 1e9;  // cells; keeps count() within 64 bits

  Vec2 low_ = Vec2::Zero(), high_ = Vec2::Zero();  // box of all segments
  double per_length_ = 0.0;                        // cells a metre
  Index count_ = 0;
  std::uint64_t mask_ = 0;
  std::vector<Index> first_;  // per bucket, start in items_
  std::vector<Index> items_;
};

template <class Visit>
void SegmentGrid::near(const Vec2& a, const Vec2& b, Visit&& visit) const {
  const Vec2 low = a.cwiseMin(b).cwiseMax(low_);
  const Vec2 high = a.cwiseMax(b).cwiseMin(high_);
  if (count_ == 0 || !(low.x() <= high.x() && low.y() <= high.y())) return;
  const Cells cells = cells_of(low, high);
  if (cells.count() > count_) {  // to look at all of them is cheaper, and bounded
    for (Index k = 0; k < count_; ++k) visit(k);
    return;
  }
  for (std::int64_t j = cells.low[1]; j <= cells.high[1]; ++j) {
    for (std::int64_t i = cells.low[0]; i <= cells.high[0]; ++i) {
      const std::size_t bucket = bucket_of(i, j);
      for (Index n = first_[bucket]; n < first_[bucket + 1]; ++n) visit(items_[static_cast<std::size_t>(n)]);
    }
  }
}

}  // namespace cleft::geometry
