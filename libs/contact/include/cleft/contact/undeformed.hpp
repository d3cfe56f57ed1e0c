/// \file
/// Contact at small strain: in the undeformed configuration, where every point of a face has its partner opposite once
/// and for all and nothing is searched.
///
/// With the tangent T and the outward normal N of the undeformed face, both fixed, and the jump d = u_+ - u_- at the
/// point,
///
///     g_N = d . N,     g_T = d . T + (X_A - X) . T,     f = W (N_+ - N_-)^T t_0,
///
/// where the anchor X_A moves along the undeformed face as the point slides, and springs and law are those of
/// springs.hpp. The force is linear in the displacement on each branch of the law. Faces may overlap visibly, as
/// displacements do not act back on the geometry.
#pragma once

#include "cleft/contact/search.hpp"

namespace cleft::contact {

/// The point opposite, with gaps and tractions, at the displacements of the faces.
Pair opposite(const Surfaces& surfaces, const FacePositions& at, Index point, const ContactState& past);

/// Internal force (N/m) and its derivative; the anchor and the mouth have no columns of their own.
PairForce force_undeformed(const Surfaces& surfaces, Index point, const Pair& pair, const ContactState& past);

/// Where the anchor lies, as a place on the face, at which the tangential gap is `target` (metres).
double anchor_place_at(const Surfaces& surfaces, const FacePositions& at, Index point, double target);

}  // namespace cleft::contact
