/// \file
/// Patches of two cells that share their change of volume and their pressure, against the locking of flow that keeps or
/// prescribes the volume.
///
/// The material of a cell of undeformed area V_i and determinant J_i is asked at
///
///     Fbar_i = (J_P/J_i)^(1/2) F_i,   J_P = sum V_m J_m / sum V_m    (small strain: F + (theta_P - theta)/2 1),
///
/// and nodal forces do the work of its stress on the rate of Fbar_i: they derive from sum V_i psi(Fbar_i) wherever the
/// law derives from psi, the balance of energies closes as without patches, and the matrix is symmetric wherever the
/// law's tangent is. Plastic laws return both cells to one pressure (constitutive/patch.hpp), so that flow prescribes
/// one change of volume a patch. So do laws whose pressure is one of the volume alone, Hencky's and linear elasticity;
/// the Neo-Hookean one has mu (|Fbar_i|^2 - 2)/3 in its mean stress, which stays each cell's own. The triangles in the
/// ball of a tip with branch functions have no cells: they are in no patch, and lock as they do without.
#pragma once

#include "cleft/assembly/model.hpp"
#include "cleft/constitutive/patch.hpp"

namespace cleft::assembly {

using constitutive::OfPatch;

/// For every cell the other one of its patch, or kNone. The edges between two cells of one material and one side of all
/// cracks become patches from the longest on, each unless one of its cells is in a patch already; of edges of one
/// length (to 1e-9 of the body's extent) that of the least x, then y, comes first. Edges that a patch would have
/// without cracks come before all others, so that a crack that grows only parts the patches that it cuts. In a
/// structured mesh patches are the rectangles, and what a crack leaves of a rectangle on each of its sides.
std::vector<Index> pair_cells(const Model& model);

/// Two cells as one element.
struct Patch {
  OfPatch<Index> cell;                   ///< ascending
  std::array<Index, 4> unknown;          ///< those of the first cell, then the one it has not
  OfPatch<std::array<int, 3>> position;  ///< of each cell's unknowns in `unknown`
};

/// Ascending in their first cell.
std::vector<Patch> patches_of(const Model& model);

/// A patch at a displacement.
struct DeformedPatch {
  OfPatch<double> share;        ///< V_i/sum V
  OfPatch<Mat2> deformation;    ///< F; small strain: F - 1, like the next
  OfPatch<Mat2> strained;       ///< Fbar
  OfPatch<double> J{1.0, 1.0};  ///< det F; 1 at small strain
  double mean = 1.0;            ///< J_P; 1 at small strain
};
/// F of a cell that is turned inside out is its own Fbar.
DeformedPatch deformed(const Model& model, const OfPatch<Index>& cells, const VecX& displacement);

/// Deformation gradient that the law of a material point is asked at: Fbar in a patch, F elsewhere (small strain: less
/// 1).
Mat2 material_deformation(const Model& model, Index number, const VecX& displacement);

/// The past of the plastic points of a patch.
constitutive::PatchPast past_of(const OfPatch<double>& share, const OfPatch<Index>& cells,
                                const std::vector<constitutive::PlasticState>& plastic, double duration);

}  // namespace cleft::assembly
