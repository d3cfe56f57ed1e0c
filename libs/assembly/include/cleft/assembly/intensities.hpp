/// \file
/// Stress intensity factors of a body in equilibrium, those of small strain. K_II is positive where the face to the
/// left, seen from the crack along its continuation, moves ahead.
#pragma once

#include "cleft/assembly/equilibrium.hpp"
#include "cleft/enrichment/sif.hpp"

namespace cleft::assembly {

/// The number in CutMesh::tips of the ball at an end (0 first, 1 last) of a crack; kNone where there is none.
Index ball_at(const Model& model, Index crack, int end);

/// By the interaction integral over a ball and over its faces, which may be closed. `tip` is a number in CutMesh::tips.
enrichment::Intensities intensities_by_integral(const Equilibrium& body, Index tip);

/// By opening and slip of the faces: K(r) = E' jump / 8 sqrt(2 pi / r) over the inner part of the ball, continued
/// linearly to r = 0.
enrichment::Intensities intensities_by_faces(const Equilibrium& body, Index tip);

}  // namespace cleft::assembly
