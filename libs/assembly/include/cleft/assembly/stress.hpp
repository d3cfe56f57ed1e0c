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

/// Stress of a material at a deformation gradient (small strain: at the displacement gradient, kinematics.hpp) and the
/// plastic state at the end of the increment; elastic materials have none.
Stress stress_of(const Material& material, const Mat2& deformation, const constitutive::PlasticState& state = {});

/// Localisation function (localisation.hpp) of a material at the same two: 1 where it does not flow, and in elastic
/// materials.
constitutive::Localisation localisation_of(const Material& material, const Mat2& deformation,
                                           const constitutive::PlasticState& state);

/// Response of a material without plastic strain to a displacement gradient of any size.
constitutive::Response respond_from_rest(const Material& material, const Mat2& displacement_gradient);

}  // namespace cleft::assembly
