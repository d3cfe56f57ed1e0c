/// \file
/// The change of volume by flow, for those who hand histories on.
#pragma once

#include "cleft/constitutive/plastic.hpp"

namespace cleft::constitutive {

/// Adds to the change of volume by flow, ln J^p = -1/2 ln det C^p^-1 (small strain: tr eps^p), in the plane and there
/// in all directions alike, as Fbar adds to that of F: after the same to both the elastic strain is what it was.
void swell_in_plane(const FinitePlastic& law, PlasticState& state, double by);
void swell_in_plane(const SmallPlastic& law, PlasticState& state, double by);

}  // namespace cleft::constitutive
