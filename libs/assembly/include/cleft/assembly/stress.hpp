/// \file
/// Stresses of a state, for those who look at it.
#pragma once

#include "cleft/assembly/state.hpp"
#include "cleft/constitutive/localisation.hpp"

namespace cleft::assembly {

/// Cauchy stress, Pa, positive in tension.
struct Stress {
  Mat2 in_plane = Mat2::Zero();
  double out_of_plane = 0.0;
};

/// What a material answers to a deformation gradient (small strain: to the displacement gradient, kinematics.hpp), with
/// what it remembers of the end of the step (nothing needed without memory).
Stress stress_of(const Material& material, const Mat2& deformation, const constitutive::PlasticState& remembered = {});

/// Localisation function (localisation.hpp) of a material at rest at a deformation gradient (likewise): 1 where it does
/// not flow, and in all materials without memory.
constitutive::Localisation localisation_of(const Material& material, const Mat2& deformation,
                                           const constitutive::PlasticState& remembered);

/// What a material that has been at rest so far answers to a displacement gradient, of any size.
constitutive::Response respond_from_rest(const Material& material, const Mat2& displacement_gradient);

}  // namespace cleft::assembly
