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
  /// Segment k runs from `starts[k]` to `ends[k]`, metres. Both spans have one length; empty is allowed.
  void build(std::span<const Vec2> starts, std::span<const Vec2> ends);

  /// Calls `visit(k)` at least once for every segment k whose bounding box meets the bounding box of a-b; others may
  /// be visited too, and one more than once.
  template <class Visit>
  void near(const Vec2& a, const Vec2& b, Visit&& visit) const;

 private:
  // for whoever implements it
  Vec2 origin_ = Vec2::Zero();
  double cell_ = 1.0;
  int nx_ = 0, ny_ = 0;
  std::vector<Index> first_;    // per cell, start in items_
  std::vector<Index> items_;
};

}  // namespace cleft::geometry
