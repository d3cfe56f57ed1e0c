// What the factorisations share.
#pragma once

#include "cleft/assembly/linear_solver.hpp"

namespace cleft::assembly {

// Smallest over largest pivot. A body that may float leaves 1e-13 or less, whatever the mesh; springs 1e6 times as
// stiff as the elements 1e-11, Poisson's ratio 0.499999 4e-7, slivers of 1e-9 of an element nothing to speak of.
inline constexpr double kSuspiciousPivot = 1e-12;

inline Factors graded(double pivot_ratio) {
  return pivot_ratio > kSuspiciousPivot ? Factors::Regular : Factors::Doubtful;
}

}  // namespace cleft::assembly
