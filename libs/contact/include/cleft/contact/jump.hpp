/// \file
/// How far the faces of a crack have come apart, open or closed.
#pragma once

#include "cleft/contact/search.hpp"

namespace cleft::contact {

/// The displacement jump: place of the left face's material point less that of the right one's, of the two that were
/// one before deformation. Components are those along the crack's direction t (first to last point) and its normal n,
/// t turned left, so that n points into the left body:
///
///     normal = (x_left - x_right) . n,     tangential = (x_left - x_right) . t
///
/// At finite strain t halves the angle between the current tangents of both faces (where these are opposite, that of
/// the undeformed crack counts); at small strain it is that of the undeformed crack. The jump depends neither on the
/// face that is integrated, nor on the order of the crack's points, nor on a rigid rotation of everything.
struct Jump {
  double normal = 0.0;      ///< metres; positive where the faces have come apart
  double tangential = 0.0;  ///< metres; positive where the left face has moved along the crack's direction
};

/// The jump at a place on a face (0 at its start, 1 at its end), the same on both faces of a segment.
Jump jump_at(const Surfaces& surfaces, const FacePositions& at, Index face, double eta);

/// Distance of a contact point from the other face, metres, 0 or more: its gap; where nothing is opposite, the jump's
/// normal component. Neither counts where it is negative.
double opening_of(const Pair& pair, const Jump& jump);

}  // namespace cleft::contact
