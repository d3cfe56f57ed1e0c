/// \file
/// Moving anchors: what contact points remember once an increment has converged.
#pragma once

#include "cleft/contact/search.hpp"

namespace cleft::contact {

/// Slip and work of one increment at one point.
struct Advance {
  Memory memory;
  double dissipation = 0.0;  ///< work of friction per unit reference area, J/m^2, not negative
};

/// Memory after a converged increment. A sliding point's anchor moves to where |eps_T g_T| = mu |t_N|, so that the next
/// increment starts from the traction just reached; a point that touches for the first time is anchored at its partner;
/// an open one forgets its anchor.
Advance advance(const Surfaces& surfaces, const FacePositions& at, Index point, const Pair& pair, const Memory& memory);

}  // namespace cleft::contact
