/// \file
/// What a converged state shows along its cracks.
#pragma once

#include "cleft/solve/stepping.hpp"

namespace cleft::results {

/// A contact point of a converged state.
struct ProfilePoint {
  Index crack = kNone;
  geometry::Side side = geometry::Side::Left;
  double s = 0.0;                         ///< arc length along the crack, metres
  Vec2 reference, current;                ///< in the scene's coordinates, metres
  double gap = 0.0;                       ///< g_N, metres; nan where nothing is opposite
  double normal = 0.0, tangential = 0.0;  ///< all traction on the face, per reference area of it, Pa
  double pressure = 0.0;                  ///< Cauchy pressure, Pa, positive in compression: -normal by the stretch
  double slip = 0.0;                      ///< cumulative, metres
  contact::Status status = contact::Status::Open;
  double partner_s = 0.0;         ///< nan where nothing is opposite
  double partner_pressure = 0.0;  ///< Cauchy pressure on the other face there, Pa
  double opening = 0.0;           ///< distance from the other face, metres, 0 or more (contact/jump.hpp)
  double jump_normal = 0.0, jump_tangential = 0.0;  ///< of the displacement, metres (contact/jump.hpp)
};

/// All contact points at the stepper's last converged state. Where both faces carry points each bears what its own
/// exert, which is half of all, and what those of the other face exert opposite, per current length of theirs.
std::vector<ProfilePoint> crack_profile(const solve::LoadStepper& stepper);

}  // namespace cleft::results
