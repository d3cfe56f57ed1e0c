// What the factorisations share.
#pragma once

namespace cleft::solve {

/// A pivot that may be rounding: over the largest pivot for UMFPACK, over the largest entry for MUMPS. A body that may
/// float leaves 1e-13 or less, whatever the mesh; springs 1e6 times as stiff as the elements 1e-11, Poisson's ratio
/// 0.499999 4e-7, slivers of 1e-9 of an element nothing to speak of.
inline constexpr double kSuspiciousPivot = 1e-12;

}  // namespace cleft::solve
