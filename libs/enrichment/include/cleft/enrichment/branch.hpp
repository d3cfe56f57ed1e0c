/// \file
/// The functions that span the singular field at a crack tip, and how they fade out.
#pragma once

#include <array>

#include "cleft/geometry/tip.hpp"

namespace cleft::enrichment {

inline constexpr int kBranches = 4;

/// The part of a ball's radius within which the functions count in full.
inline constexpr double kPlateau = 0.65;

/// Where strains are finite, the length over which the functions are blunt, as a part of the size of the tip's element.
/// Enough for the sliding block of Liu and Borja to reach its full load without one increment cut; with sharp functions
/// its run ends at 15 % of that.
inline constexpr double kBlunting = 0.5;

/// The four functions at one point. Only the second jumps over the crack, by twice its radial part.
struct Branches {
  std::array<double, kBranches> value{};   ///< m^(1/2)
  std::array<Vec2, kBranches> gradient{};  ///< m^(-1/2)
};

/// sqrt(r) {cos(t/2), sin(t/2), sin(t/2) sin t, cos(t/2) sin t} at the angle t (Belytschko and Black 1999): linear
/// combinations are the displacement of an elastic body at a crack tip. Gradients are zero at the tip itself.
///
/// With a `blunting` b (metres) the radial part is r / sqrt(r + b), whose slope is at most b^(-1/2). Strains that grow
/// without bound are a solution at small strain only: at finite strain they turn the points next to a tip in mode II
/// inside out, whatever the amplitudes, within a distance that does not shrink with the elements. Where b is a part of
/// the element's size slopes still grow as h^(-1/2), and the order of convergence that sharp functions restore is lost.
Branches branches(const geometry::TipPolar& at, double blunting = 0.0);

/// chi(r): 1 up to `plateau`, 0 from `radius` on (metres), between them a polynomial of degree 5 with two continuous
/// derivatives.
struct Cutoff {
  double value = 0.0;
  double slope = 0.0;  ///< 1/m
};
Cutoff cutoff(double r, double plateau, double radius);

}  // namespace cleft::enrichment
