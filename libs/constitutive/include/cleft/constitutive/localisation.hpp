/// \file
/// Loss of ellipticity: is there a direction in which continued flow may concentrate in a band?
///
/// A band with unit normal n in the current plane can form where the acoustic tensor Q_ik = c_ijkl n_j n_l is singular
/// (Rudnicki and Rice 1975, J. Mech. Phys. Solids 23, 371-394). The localisation function is the minimum of det Q over
/// n, divided by its elastic value (lambda + 2 mu) mu: 1 in an elastic state, positive where flow stays diffuse,
/// negative where bands may form. c is the tangent of continued flow, not of a step: d sigma/d eps at small strain, and
/// d tau_ij/d g_kl - tau_il delta_jk at finite strain, where g = dF F^-1.
///
/// With n along (1, t) the determinant is a quartic P(t) over (1 + t^2)^2, so a minimum is a root of
/// P'(t) (1 + t^2) - 4 t P(t), a quartic again. Its roots are isolated by those of its derivatives and found by
/// Newton's method with bisection as safeguard; nothing is sampled.
#pragma once

#include "cleft/constitutive/plastic.hpp"

namespace cleft::constitutive {

/// A minimum over the directions in the plane.
struct Localisation {
  double value = 1.0;
  double angle = 0.0;  ///< of the band normal from the x axis, degrees in [0, 180); of equal minima the smallest
};

/// det(n.c.n) at an angle of n in degrees, Pa^2; c_ijkl has row i + 2 j and column k + 2 l.
double acoustic_determinant(const Mat4& moduli, double angle);

/// Minimum of det(n.c.n), Pa^2, and where it is. If the determinant does not depend on the direction the angle is 0.
Localisation weakest_direction(const Mat4& moduli);

/// Localisation function of a state at rest at F. Exactly 1 (angle 0) where the state is elastic, that is not on the
/// yield surface or never yielded. Exactly 0 (angle 0) on the apex of the cone: continued flow resists no shear there,
/// so that every direction is critical.
Localisation localisation(const FinitePlastic& law, const Mat2& deformation, const PlasticState& state);
Localisation localisation(const SmallPlastic& law, const Mat2& deformation, const PlasticState& state);

}  // namespace cleft::constitutive
