/// \file
/// Bodies with tips in all kinds of places, for tests.
#pragma once

#include <string>

#include "plate.hpp"

namespace cleft::enrichment::test {

struct TipBody {
  std::string name;
  Plate plate;
  std::vector<Vec2> crack;

  /// The side of the crack on which a point near the tip or behind it lies.
  geometry::Side side(const Vec2& point) const {
    const bool positive = plate.cut.tips[0].frame.at(point).angle > 0.0;
    return positive == (plate.cut.tips[0].end == 1) ? geometry::Side::Left : geometry::Side::Right;
  }
};

/// Boxes of [-1, 1]^2 with one tip near the middle and its ball of radius 0.5: inside a triangle, on an edge and on a
/// node; straight, bent within the ball, and bent within the tip's own triangle; with the tip at either end.
inline std::vector<TipBody> tip_bodies(int n) {
  std::vector<TipBody> bodies;
  const auto add = [&](const std::string& name, std::vector<Vec2> crack) {
    for (const bool reversed : {false, true}) {
      if (reversed) std::reverse(crack.begin(), crack.end());
      bodies.push_back({name + (reversed ? ", from its tip" : ""),
                        Plate(geometry::structured_mesh({-1, -1, 1, 1}, {n, n}, geometry::Diagonal::Alternating),
                              {{"crack", crack, 0.5}}),
                        crack});
    }
  };
  const double h = 2.0 / n;
  const Vec2 tip(0.3 * h, 0.2 * h);
  add("straight", {{-2.0, 0.1}, tip});
  add("inclined", {{-1.5, -1.1}, tip});
  add("on an edge", {{-2.0, 0.13}, {0.0, 0.4 * h}});
  add("on a node", {{-2.0, 0.13}, {0.0, 0.0}});
  add("along mesh lines", {{-2.0, 0.0}, {0.4 * h, 0.0}});
  add("along mesh lines to a node", {{-2.0, 0.0}, {0.0, 0.0}});
  add("bent", {{-2.0, -0.2}, {-0.42, 0.12}, {-0.2, 0.07}, tip});
  add("bent in its triangle", {{-2.0, 0.2}, {0.1 * h, 0.2 * h}, {0.22 * h, 0.1 * h}, {0.4 * h, 0.13 * h}});
  return bodies;
}

}  // namespace cleft::enrichment::test
