/// \file
/// Nodal forces of a patch and their derivative.
#pragma once

#include "cleft/assembly/f_bar.hpp"

namespace cleft::assembly {

/// Over the components of the patch's four unknowns.
struct PatchForces {
  Eigen::Matrix<double, 8, 1> force;   ///< N/m
  Eigen::Matrix<double, 8, 8> matrix;  ///< N/m^2
};

/// Of a patch that is not turned inside out, with what its laws answer at `deformed.strained`.
PatchForces patch_forces(const Model& model, const Patch& patch, const DeformedPatch& deformed,
                         const constitutive::PatchResponse& response, bool small_strain);

}  // namespace cleft::assembly
