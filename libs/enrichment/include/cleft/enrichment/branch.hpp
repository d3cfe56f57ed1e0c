/// \file
/// The functions that span the singular field at a crack tip, cut off smoothly.
#pragma once

#include <array>

#include "cleft/geometry/tip.hpp"

namespace cleft::enrichment {

inline constexpr int kBranches = 4;

/// The part of a ball's radius within which the functions are not cut off.
inline constexpr double kPlateau = 0.3;

/// The four functions at one point. Only the second jumps over the crack, by 2 sqrt(r).
struct Branches {
  std::array<double, kBranches> value{};   ///< m^(1/2)
  std::array<Vec2, kBranches> gradient{};  ///< m^(-1/2)
};

/// sqrt(r) {cos(t/2), sin(t/2), sin(t/2) sin t, cos(t/2) sin t} at the angle t (Belytschko and Black 1999): linear
/// combinations are the displacement of an elastic body at a crack tip. Gradients are zero at the tip itself.
Branches branches(const geometry::TipPolar& at);

/// chi(r): 1 up to `plateau`, 0 from `radius` on (metres), between them a polynomial of degree 5 with two continuous
/// derivatives.
struct Cutoff {
  double value = 0.0;
  double slope = 0.0;  ///< 1/m
};
Cutoff cutoff(double r, double plateau, double radius);

/// The four functions times chi, at `point` of the ball; `plateau` is a fraction of its radius. What the side does is
/// said at TipFrame::at.
Branches branches_in_ball(const geometry::TipBall& ball, double plateau, const Vec2& point, geometry::MaybeSide side);

}  // namespace cleft::enrichment
