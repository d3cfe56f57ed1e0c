/// \file
/// Patches of two triangles that share their change of volume (F-bar), against the locking of flow that keeps or
/// prescribes the volume.
///
/// The material of a triangle is asked at (de Souza Neto, Pires and Owen 2005, Int. J. Numer. Methods Eng. 62, 353-383)
///
///     Fbar = (J_P/J)^(1/2) F,   J_P = sum v / sum V over the patch     (small strain: F + (theta_P - theta)/2 1),
///
/// and its Kirchhoff stress acts on the true shape: P = Pbar (J/J_P)^(1/2), with Pbar the law's answer to Fbar. The
/// nodal forces do not derive from an energy, so that the balance of energies does not close exactly, and the tangent
/// has no symmetry.
#pragma once

#include "cleft/assembly/model.hpp"

namespace cleft::assembly {

/// For every cell the other one of its patch, or kNone. Two whole cells are a patch if their longest edge is the same
/// and no crack lies between; in a structured mesh those are the two triangles of a rectangle.
std::vector<Index> pair_cells(const Model& model);

/// A cell in its patch, and the rate of J_P there: d ln J_P = share by_own : dF + (1 - share) by_other : dF_other. At
/// small strain `stretch` is 1, and theta_P takes the place of ln J_P.
struct PatchedCell {
  Mat2 deformation;                                     ///< F; small strain: F - 1, like the next
  Mat2 strained;                                        ///< Fbar
  double stretch = 1.0;                                 ///< (J_P/J)^(1/2)
  double share = 0.0;                                   ///< of the cell in the volume of its patch
  Mat2 by_own = Mat2::Zero(), by_other = Mat2::Zero();  ///< F^-T
};
PatchedCell patched(const Model& model, Index cell, const VecX& displacement);

/// Deformation gradient that the law of a material point is asked at: Fbar in a patch, F elsewhere (small strain: less
/// 1).
Mat2 material_deformation(const Model& model, Index number, const VecX& displacement);

}  // namespace cleft::assembly
