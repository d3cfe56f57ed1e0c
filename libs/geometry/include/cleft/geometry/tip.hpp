/// \file
/// The neighbourhood of a crack tip whose singular field an enrichment represents.
#pragma once

#include <array>
#include <vector>

#include "cleft/geometry/crack.hpp"

namespace cleft::geometry {

/// Polar coordinates about a tip, bent so that the crack is the line angle = +-pi at every radius.
struct TipPolar {
  double r = 0.0;                      ///< metres
  double angle = 0.0;                  ///< radians, 0 straight ahead of the crack, counter-clockwise
  Vec2 r_gradient = Vec2::Zero();      ///< 1, a unit vector; zero at the tip itself
  Vec2 angle_gradient = Vec2::Zero();  ///< 1/m; zero at the tip itself
};

/// Measures polar coordinates about a tip. With phi the polar angle of a point seen from the tip, and alpha(r) the one
/// at which the crack crosses the circle of radius r, the angle is phi - alpha(r) -+ pi: where the crack is straight,
/// the usual one, and where it bends, turned about the tip circle by circle.
class TipFrame {
 public:
  TipFrame() = default;

  /// `points` of the crack from the tip outward, at least two, the first one the tip, the distance from it growing all
  /// along; beyond the last of them the crack goes on straight. `positive` is the side of the crack at angle = +pi.
  TipFrame(const std::vector<Vec2>& points, Side positive);

  const Vec2& tip() const { return tip_; }

  /// Unit vector straight ahead, against the crack's first segment.
  Vec2 ahead() const { return -arms_.front().along; }

  /// Distance from the tip to the crack's first bend, metres; infinite if there is none.
  double straight_until() const;

  /// Coordinates of `point` (metres). Without a side the angle is in (-pi, pi]. With one, a point that lies within 90
  /// degrees of the crack is taken to be on this side, and if it is really beyond the crack, the angle goes on past
  /// +-pi to it. So it tells the two faces apart, and continues a field of one side smoothly to the other side's
  /// points.
  TipPolar at(const Vec2& point, MaybeSide side = {}) const;

 private:
  /// A straight piece of the crack, which lies `offset` to the left of the parallel through the tip.
  struct Arm {
    double r = 0.0;  // where it begins
    Vec2 along;
    double offset = 0.0;
  };

  Vec2 tip_ = Vec2::Zero();
  Side positive_ = Side::Left;
  std::vector<Arm> arms_;
};

/// A tip with branch functions: it stays where the polyline ends, and the enrichment lives within `radius` of it.
struct TipBall {
  Index crack = kNone;
  int end = 0;          ///< of the crack: 0 its first, 1 its last point
  double radius = 0.0;  ///< metres
  /// How far an integral around the tip may go: within this distance the crack is straight and the body whole. The
  /// least of the radius, of the distance to the crack's first bend, and of that to the boundary; metres.
  double reach = 0.0;
  TipFrame frame;
  Index element = kNone;  ///< the triangle that contains the tip; where that is on an edge or node, one of them
  /// This triangle, divided by the crack and its straight continuation ahead of the tip, by Side; counter-clockwise.
  std::array<std::vector<std::array<Vec2, 3>>, 2> sub_triangles;
};

}  // namespace cleft::geometry
