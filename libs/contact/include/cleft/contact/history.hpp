/// \file
/// Moving anchors: the states of contact points at the end of a converged increment.
#pragma once

#include "cleft/contact/search.hpp"

namespace cleft::contact {

/// State of a point, and the work of its tractions in one increment that is not stored, J/m^2 of reference area.
struct CommittedPoint {
  ContactState end;
  double friction = 0.0;  ///< dissipated: 0 without friction, and never negative
  double pressure = 0.0;  ///< of the pressure along sloping faces, and of springs that lose their partner
};

/// State after a converged increment. A sliding point's anchor moves to where |eps_T g_T| is the strength, so that the
/// next increment starts from the traction just reached; a point that touches for the first time is anchored at its
/// partner; an open one forgets its anchor.
///
/// What is not stored, with the ramp w, the slide ds of the partner along t, its part ds_p beyond the elastic one and
/// the slope r = (e . n) / (e . t) of the partner's segment e against the point's own:
///
///     w t_T ds_p            friction
///     w t_N r ds            the pressure, where the faces are not parallel and the partner climbs or descends
///     -psi dw               springs that lose their partner at a mouth, psi = Springs::stored_energy
///
/// A point sticks until its traction has reached the strength, slides from there on, and no longer where it opens:
/// strength times slide, so reckoned that it is exact where the strength stays the same. The others are by the
/// trapezoidal rule.
CommittedPoint commit(const Surfaces& surfaces, const FacePositions& at, Index point, const Pair& pair,
                      const ContactState& past);

/// Friction, J/m^2, of a point that was open and touches at the end of an increment. When it touched is not known: half
/// of the increment counts, over which the pressure rises from 0. The law lets the point slide freely until its first
/// increment has ended, and so the balance of energies misses this work. `before`: positions at its beginning,
/// `state` of that time.
double touching_friction(const Surfaces& surfaces, const FacePositions& before, const FacePositions& at, Index point,
                         const Pair& pair, const ContactState& past);

/// State of a point that carries no traction of its own (mortar contact): its anchor is its partner, and its slip what
/// it has moved from the last one while it slid.
ContactState follow(const Surfaces& surfaces, const FacePositions& at, Index point, const Pair& pair,
                    const ContactState& past);

}  // namespace cleft::contact
