/// \file
/// Drucker-Prager and J2 plasticity at finite and at small strain, plane strain: one return map, two kinematics.
///
/// Finite strain (multiplicative plasticity, exponential map). The trial elastic deformation is b^e = F C^p^-1 F^T in
/// the plane and b^e_33 = C^p^-1_33 beside it. Its logarithmic strain (1/2) ln b^e enters the return map as a small
/// strain would and gives the Kirchhoff stress tau; the plastic increment is taken off the logarithm,
///
///     b^e = exp(-2 plastic increment) b^e_trial,      C^p^-1 = F^-1 b^e F^-T.
///
/// All of this is coaxial, and isotropic functions of plane tensors need no eigenvectors (plane_tensor.hpp,
/// logarithm.hpp). For the tangent let g = dF F^-1, with t = g_11 + g_22, d = (g_11 - g_22, g_12 + g_21) and the spin q
/// = g_21 - g_12. The trial Mohr circle of b^e, m (1 +- |w|), moves by db^e = g b^e + b^e g^T, and its logarithmic
/// strain by
///
///     d centre = t/2,      d radius = A/2 (d + q (-w_2, w_1)) - B/2 w (w . d),
///
/// with A and B of r = w.w: the spectral tangent with its divided differences (beta_B - beta_A)/(b_B - b_A) in a form
/// in which nothing is divided by a difference of principal values. Small strain is w = 0, A = 1. Then dP_iJ = (d
/// tau_ij - tau_il g_jl) F^-1_Jj (Liu and Borja 2010, (72)).
///
/// Signs: stress positive in tension. All need det F > 0 (small strain: any H); what is not finite comes out not
/// finite.
#pragma once

#include "cleft/constitutive/drucker_prager.hpp"
#include "cleft/constitutive/patch.hpp"
#include "cleft/constitutive/plastic_state.hpp"
#include "cleft/constitutive/response.hpp"

namespace cleft::constitutive {

/// Tangent of continued flow at a state at rest.
struct ContinuumTangent {
  Branch branch;
  Mat4 moduli;  ///< c_ijkl = d tau_ij/d g_kl - tau_il delta_jk (small strain: d sigma_ij/d eps_kl), Pa; row i + 2 j
};

/// Finite strain. History is C^p^-1 - I.
struct FinitePlastic : DruckerPrager {
  /// First Piola-Kirchhoff stress and algorithmic tangent dP/dF after a step from `committed` to F; `updated` is the
  /// state at its end, which is `committed` itself if the step is elastic.
  Response respond(const Mat2& deformation, const PlasticState& committed, PlasticState& updated,
                   double duration = kForever) const;

  /// The same of a patch whose points share their pressure (patch.hpp).
  PatchResponse respond(const OfPatch<Mat2>& deformation, const PatchPast& past) const;

  /// Stored energy of the elastic strain per unit reference volume, J/m^3, at F with the state of the end of the step.
  /// What hardening consumes counts as dissipated.
  double energy(const Mat2& deformation, const PlasticState& updated) const;

  /// Plastic work of the step to F, with the stress at its end.
  PlasticWork dissipation(const Mat2& deformation, const PlasticState& committed, double duration = kForever) const;

  /// The same of a patch, per undeformed volume of both points.
  PlasticWork dissipation(const OfPatch<Mat2>& deformation, const PatchPast& past) const;

  /// tau_33 at F with the state of the end of the step, Pa.
  double out_of_plane_stress(const Mat2& deformation, const PlasticState& updated) const;

  /// Tangent of continued flow at F and the state at rest there, for the analysis of localisation.
  ContinuumTangent continuum_tangent(const Mat2& deformation, const PlasticState& updated) const;

  /// Whether a step that flows has returned to the apex of the cone: at F with the state of its end the elastic strain
  /// has no deviator.
  bool is_on_apex(const Mat2& deformation, const PlasticState& updated) const;

  /// What one point remembers that takes the place of several: the means of ln C^p^-1 and of what has accumulated. So
  /// ln det C^p^-1 is the mean, too, and flow at constant volume stays that; the mean of C^p^-1 itself would swell
  /// (diag(4, 1/4) and diag(1/4, 4) to the determinant 4.5). What all have in common is the mean to the last bit. Needs
  /// C^p^-1 positive definite, as it always is.
  static PlasticState mean(std::span<const WeightedState> states);

  /// Gives both points of a patch the mean of their ln det C^p^-1 by volume, which is all that their common pressure
  /// knows of it; the other parts of ln C^p^-1 stay. To the last bit what is one for both already.
  static void share_volume(OfPatch<PlasticState>& states, const OfPatch<double>& share);
};

/// Small strain, eps = sym(H) of the displacement gradient H. History is the plastic strain; `piola` is the Cauchy
/// stress, and its tangent has both minor symmetries. The members are those of FinitePlastic; means are those of the
/// plastic strain.
struct SmallPlastic : DruckerPrager {
  Response respond(const Mat2& gradient, const PlasticState& committed, PlasticState& updated,
                   double duration = kForever) const;
  PatchResponse respond(const OfPatch<Mat2>& gradient, const PatchPast& past) const;
  double energy(const Mat2& gradient, const PlasticState& updated) const;
  PlasticWork dissipation(const Mat2& gradient, const PlasticState& committed, double duration = kForever) const;
  PlasticWork dissipation(const OfPatch<Mat2>& gradient, const PatchPast& past) const;
  double out_of_plane_stress(const Mat2& gradient, const PlasticState& updated) const;
  ContinuumTangent continuum_tangent(const Mat2& gradient, const PlasticState& updated) const;
  bool is_on_apex(const Mat2& gradient, const PlasticState& updated) const;
  static PlasticState mean(std::span<const WeightedState> states) { return linear_mean(states); }
  static void share_volume(OfPatch<PlasticState>& states, const OfPatch<double>& share);
};

}  // namespace cleft::constitutive
