/// \file
/// Stress intensity factors of a body in equilibrium, those of small strain. K_II is positive where the face to the
/// left, seen from the crack along its continuation, moves ahead.
///
/// They do not change when the body is turned rigidly. With the rotation R of the polar decomposition of the mean
/// deformation gradient within the reach of a tip (geometry::TipBall), the displacement gradient is R^T F - 1, the
/// stress R^T P with the first Piola-Kirchhoff stress P, and jumps and tractions t are R^T t. P is in balance over the
/// body at rest, over which the integral runs, and so is R^T P, since R is one for the whole tip. Where strains and
/// turns are small both are what they are at small strain; there the mean infinitesimal turn is left out, too.
#pragma once

#include "cleft/assembly/equilibrium.hpp"
#include "cleft/enrichment/sif.hpp"

namespace cleft::growth {

/// By the interaction integral over a ball and over its faces, which may be closed. `tip` is a number in CutMesh::tips.
/// Not a number where a tip has none (kLeastReach).
enrichment::Intensities intensities_by_integral(const assembly::Equilibrium& body, Index tip);

/// By opening and slip of the faces: K(r) = E' jump / 8 sqrt(2 pi / r) over the inner part of the ball, continued
/// linearly to r = 0. Not a number where a tip has none (kLeastReach), or fewer than two places lie within its reach
/// and beyond the blunt part of the functions.
enrichment::Intensities intensities_by_faces(const assembly::Equilibrium& body, Index tip);

}  // namespace cleft::growth
