/// \file
/// Spatial search among line segments that move.
#pragma once

#include <span>
#include <vector>

#include "cleft/support/types.hpp"

namespace cleft::geometry {

/// A uniform grid over segments of the plane. Rebuilding reuses its memory. Building is O(segments), a query touches only
/// the cells that the box of the query segment covers.
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
  struct Range {
    int x0, x1, y0, y1;
  };
  Range cells_of(const Vec2& low, const Vec2& high) const;

  Vec2 origin_ = Vec2::Zero();
  double cell_ = 1.0;
  int nx_ = 0, ny_ = 0;
  std::vector<Index> first_;  // per cell, where its segments start in items_
  std::vector<Index> items_;
  std::vector<Index> fill_;
};

template <class Visit>
void SegmentGrid::near(const Vec2& a, const Vec2& b, Visit&& visit) const {
  if (nx_ == 0) return;
  const Range range = cells_of(a.cwiseMin(b), a.cwiseMax(b));
  for (int y = range.y0; y <= range.y1; ++y)
    for (int x = range.x0; x <= range.x1; ++x) {
      const int cell = y * nx_ + x;
      for (Index k = first_[cell]; k < first_[cell + 1]; ++k) visit(items_[k]);
    }
}

}  // namespace cleft::geometry
