/// \file
/// From a description to a problem that is ready to be solved.
#pragma once

#include "cleft/assembly/stepping.hpp"
#include "cleft/growth/evolution.hpp"
#include "cleft/scene/description.hpp"
#include "cleft/scene/field.hpp"

namespace cleft::scene {

/// Meshes, cuts, numbers and binds boundary values. A body far from the scene's origin gets coordinates of its own
/// (assembly::Model::origin). Throws InputError, located in the scene, on what only then shows: a
/// crack outside the body, boundaries that contradict each other at a shared node, a box without nodes.
assembly::Model build_model(const Scene& scene);

/// The body that `build_model` has made of the scene, with cracks that grow as the scene says. When they do it is
/// discretised anew on the same mesh; its penalties stay.
growth::Evolution make_evolution(const Scene& scene, assembly::Model model);

/// Young's modulus over the mean size of the elements that each crack cuts, Pa/m: the default of both penalties. Of
/// several materials along a crack the softest counts.
std::vector<double> penalty_scale(const Scene& scene, const assembly::Model& model);

/// Mean size of the elements that each crack cuts, metres: the side of a square of two such triangles.
std::vector<double> cut_sizes(const assembly::Model& model);

/// What is allowed but may surprise, one line each, with the figure that speaks for it: ends of cracks that were moved
/// or lie close to the boundary, few elements along a crack or in the ball of a tip, no friction, penalties far from
/// E/h, Poisson's ratios at which triangles lock or below 0, displacements that are not zero at load 0, tractions where
/// nothing can move.
std::vector<std::string> remarks(const Scene& scene, const assembly::Model& model);

assembly::StepControls step_controls(const Scene& scene);

/// Norms of the error against an exact solution in the model's coordinates, and of that solution itself: L2 of the
/// displacement (m^2), and the energy norm of small strain (sqrt(J/m)).
struct ErrorNorms {
  double l2 = 0.0, energy = 0.0, l2_exact = 0.0, energy_exact = 0.0;
};
ErrorNorms error_norms(const assembly::Model& model, const Field& exact, double factor, const VecX& displacement);

}  // namespace cleft::scene
