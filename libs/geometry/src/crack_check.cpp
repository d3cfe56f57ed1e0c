#include "crack_check.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cleft/geometry/distance.hpp"
#include "cleft/geometry/segment_grid.hpp"
#include "cleft/support/error.hpp"
#include "predicates.hpp"

namespace cleft::geometry {

namespace {

void check_points(const Crack& crack) {
  if (crack.points.size() < 2) throw CrackError(crack, "has fewer than two points; a crack needs at least two");
  if (!(crack.tip_radius >= 0.0) || !std::isfinite(crack.tip_radius)) {
    throw CrackError(crack, "has a tip radius that is negative or not finite; allowed: 0 (none) or more");
  }
  for (std::size_t k = 0; k < crack.points.size(); ++k) {
    if (!crack.points[k].allFinite()) {
      throw CrackError(crack, "point " + std::to_string(k + 1) + " is not finite");
    }
    if (k > 0 && crack.points[k] == crack.points[k - 1]) {
      throw CrackError(crack, "points " + std::to_string(k) + " and " + std::to_string(k + 1) +
                                  " coincide; consecutive points must differ");
    }
  }
}

// Segments nearer than rounding touch: which way round they pass each other is no property of the crack.
bool touch(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  if (segments_meet(a, b, c, d)) return true;
  constexpr double kTouch = 1e-13;
  const double distance = std::min({distance_to_segment(a, b, c), distance_to_segment(a, b, d),
                                    distance_to_segment(c, d, a), distance_to_segment(c, d, b)});
  return distance <= kTouch * ((b - a).norm() + (d - c).norm());
}

}  // namespace

void check_cracks(const std::vector<Crack>& cracks) {
  std::vector<Vec2> starts, ends;
  std::vector<std::pair<std::size_t, std::size_t>> place;  // crack and segment
  for (std::size_t c = 0; c < cracks.size(); ++c) {
    check_points(cracks[c]);
    const auto& points = cracks[c].points;
    for (std::size_t k = 0; k + 1 < points.size(); ++k) {
      starts.push_back(points[k]);
      ends.push_back(points[k + 1]);
      place.emplace_back(c, k);
    }
  }
  SegmentGrid grid;
  grid.build(starts, ends);
  for (std::size_t m = 0; m < starts.size(); ++m) {
    const auto [crack, segment] = place[m];
    grid.near(starts[m], ends[m], [&](Index visited) {
      const auto k = static_cast<std::size_t>(visited);
      if (k <= m) return;
      if (place[k].first == crack && place[k].second == segment + 1) {
        if (folds_back(starts[m], ends[m], ends[k])) {
          throw CrackError(cracks[crack], "folds back on itself at point " + std::to_string(segment + 2));
        }
        return;
      }
      if (!touch(starts[m], ends[m], starts[k], ends[k])) return;
      if (place[k].first == crack) {
        throw CrackError(cracks[crack], "crosses or touches itself: its segments " + std::to_string(segment + 1) +
                                            " and " + std::to_string(place[k].second + 1) +
                                            " meet, which is not allowed");
      }
      throw CrackError(cracks[crack], "crosses or touches crack " + cracks[place[k].first].name +
                                          "; cracks must keep clear of each other");
    });
  }
}

}  // namespace cleft::geometry
