/// \file
/// A linear elastic plate with cracks at small strain: the smallest program that shows the orders of the approximation.
#pragma once

#include <Eigen/SparseCore>

#include "cleft/enrichment/tip_points.hpp"
#include "crack_field.hpp"

namespace cleft::enrichment::test {

struct Errors {
  double energy = 0.0;        ///< of the gradient in the energy norm, over that of the exact field
  double displacement = 0.0;  ///< of the displacement in the L2 norm, likewise
};

struct Plate {
  geometry::Mesh mesh;
  geometry::CutMesh cut;
  Unknowns unknowns;
  std::vector<Cell> cells;
  std::vector<TipPoint> points;
  Elastic elastic;

  Plate(geometry::Mesh body, const std::vector<geometry::Crack>& cracks, double plateau = kPlateau, int refinement = 0);

  /// Exact values of the unknowns on the boundary of the mesh and their ghosts, kFree elsewhere.
  std::vector<bool> prescribed() const;

  Eigen::SparseMatrix<double> stiffness() const;

  /// Displacement under exact values on the boundary, and forces on the unknowns besides.
  VecX solve(const CrackField& exact, const VecX& forces = {}) const;

  /// Nodal values of the exact field, amplitudes 0.
  VecX interpolate(const CrackField& exact) const;

  Errors errors(const CrackField& exact, const VecX& u) const;

  /// Largest over smallest eigenvalue of the stiffness of the free unknowns with its diagonal scaled to 1.
  double condition() const;
};

/// A box of [-1, 1]^2 with n cells a side, and a crack that runs into it in `direction` (radians) and ends at `tip`.
Plate box_with_crack(int n, const Vec2& tip, double direction, double radius, double plateau = kPlateau,
                     int refinement = 0);

}  // namespace cleft::enrichment::test
