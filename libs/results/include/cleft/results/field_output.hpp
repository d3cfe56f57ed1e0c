/// \file
/// What a converged state shows over the body and on the faces of its cracks.
#pragma once

#include "cleft/results/crack_profile.hpp"
#include "cleft/results/vtu.hpp"

namespace cleft::results {

/// In the scene's coordinates: displacement, Cauchy stress (xx yy zz xy yz xz), mean and maximum principal stress, and
/// of a plastic material the accumulated plastic strain (the sum of the multipliers), the localisation function and the
/// angle of its minimum (degrees, of the normal of the band from the x axis); each side of a cut triangle has its own
/// points. In the ball of a tip a part of a triangle shows its mean stress and plastic strain and its least
/// localisation function.
VtuGrid bulk_output(const assembly::Model& model, const assembly::State& state);

/// Extremes over the body of a plastic material at rest: 0 and 1 without memory.
struct PlasticExtremes {
  double largest_strain = 0.0;  ///< accumulated
  double least_localisation = 1.0;
};
PlasticExtremes plastic_extremes(const assembly::Model& model, const assembly::State& state);

/// Both faces of every crack as lines with displacement and side, and of the middle of each line the opening and the
/// jump of the displacement. Where the face carries contact points (NaN on the other) also the means of their pressure,
/// tractions, slip and gap (NaN where nothing is opposite), and the largest status: 0 open, 1 stick, 2 slip.
VtuGrid face_output(const assembly::Model& model, const assembly::State& state,
                    const std::vector<ProfilePoint>& points);

}  // namespace cleft::results
