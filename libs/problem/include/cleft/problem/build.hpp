/// \file
/// From a specification to a model: the only builder of one.
#pragma once

#include "cleft/problem/field.hpp"
#include "cleft/problem/specification.hpp"
#include "cleft/solve/stepping.hpp"

namespace cleft::problem {

/// Meshes, cuts, numbers and binds boundary values. A body far from the scene's origin gets coordinates of its own
/// (assembly::Model::origin). Throws InputError, located in the scene, on what only then shows: a
/// crack outside the body, boundaries that contradict each other at a shared node, a box without nodes.
assembly::Model build_model(const Specification& specification);

/// The same body on the same mesh with other cracks: as many of them as `model` has, grown. Penalties stay. Throws
/// InputError.
assembly::Model recut(const Specification& specification, const assembly::Model& model,
                      std::vector<geometry::Crack> cracks);

/// Young's modulus over the mean size of the elements that each crack cuts, Pa/m: the default of both penalties. Of
/// several materials along a crack the softest counts.
std::vector<double> penalty_scale(const Specification& specification, const assembly::Model& model);

/// Mean size of the elements that each crack cuts, metres: the side of a square of two such triangles.
std::vector<double> cut_sizes(const assembly::Model& model);

solve::StepControls step_controls(const Specification& specification);

/// Norms of the error against an exact solution in the model's coordinates, and of that solution itself: L2 of the
/// displacement (m^2), and the energy norm of small strain (sqrt(J/m)).
struct ErrorNorms {
  double l2 = 0.0, energy = 0.0, l2_exact = 0.0, energy_exact = 0.0;
};
ErrorNorms error_norms(const assembly::Model& model, const Field& exact, double factor, const VecX& displacement);

}  // namespace cleft::problem
