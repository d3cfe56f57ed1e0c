/// \file
/// What a converged state shows: crack profiles and fields.
#pragma once

#include "cleft/results/vtu.hpp"
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
std::vector<ProfilePoint> profile(const solve::LoadStepper& stepper);

/// In the scene's coordinates: displacement, Cauchy stress (xx yy zz xy yz xz), mean and maximum principal stress, and
/// of a plastic material the accumulated plastic strain (the sum of the multipliers), the localisation function and the
/// angle of its minimum (degrees, of the normal of the band from the x axis); each side of a cut triangle has its own
/// points. In the ball of a tip a part of a triangle shows its mean stress and plastic strain and its least
/// localisation function.
VtuGrid bulk_grid(const assembly::Model& model, const assembly::State& state);

/// Extremes over the body of a plastic material at rest: 0 and 1 without memory.
struct PlasticExtremes {
  double largest_strain = 0.0;  ///< accumulated
  double least_localisation = 1.0;
};
PlasticExtremes plastic_extremes(const assembly::Model& model, const assembly::State& state);

/// Both faces of every crack as lines with displacement and side, and of the middle of each line the opening and the
/// jump of the displacement. Where the face carries contact points (NaN on the other) also the means of their pressure,
/// tractions, slip and gap (NaN where nothing is opposite), and the largest status: 0 open, 1 stick, 2 slip.
VtuGrid face_grid(const assembly::Model& model, const assembly::State& state, const std::vector<ProfilePoint>& points);

}  // namespace cleft::results
