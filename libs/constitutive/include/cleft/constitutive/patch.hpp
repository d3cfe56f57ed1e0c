/// \file
/// Two material points of one plastic law that share their pressure: a patch, against the locking of flow that
/// prescribes the change of volume.
///
/// With the shares w_i of the points in the volume of the patch and the trial states of drucker_prager.hpp, the common
/// pressure is that of the mean trial strain less the mean flow, and each point has a multiplier of its own:
///
///     p = p_tr - K b sum_i w_i dgamma_i,     p_tr = K sum_i w_i tr(e_i)
///     dgamma_i >= 0,   f_i = |s_i| + beta p - alpha_i(gamma_i) <= 0,   dgamma_i f_i = 0,
///     plastic strain increments   dgamma_i s_i/|s_i| + b/3 sum_m w_m dgamma_m 1.
///
/// So a patch flows as associated plasticity does on the product of both stress spaces with the cone |s_i| + beta p <=
/// alpha_i, i = 1, 2, if beta = b: forces have an energy per increment, and the flow's change of volume is one
/// condition a patch, not one a point. Given p each multiplier is a convex and rising function of p, piecewise linear,
/// and so is
///
///     p - p_tr + K b sum_i w_i dgamma_i(p) = 0,
///
/// which Newton's method from p_tr solves exactly after as many steps as there are pieces at most. A point is on its
/// apex where beta p > alpha_i + H |s_tr,i|/(2 mu); without hardening and viscosity both are at once, p = alpha/beta,
/// and share what flow the shape does not ask for equally.
#pragma once

#include <array>

#include "cleft/constitutive/drucker_prager.hpp"
#include "cleft/constitutive/plastic_state.hpp"

namespace cleft::constitutive {

/// One of each point of a patch.
template <class T>
using OfPatch = std::array<T, 2>;

/// Where a patch begins a step.
struct PatchPast {
  OfPatch<double> share;  ///< of the undeformed volume; sum 1
  OfPatch<PlasticState> state;
  double duration = kForever;
};

/// First Piola-Kirchhoff stresses (small strain: Cauchy stresses) and how they move,
///
///     dP_i = tangent_i : dF_i + by_pressure_i dp,     dp = sum_m pressure_rate_m : dF_m.
struct PatchResponse {
  OfPatch<Mat2> piola;          ///< Pa
  OfPatch<Mat4> tangent;        ///< dP_i/dF_i at constant pressure, Pa; layout of Response
  OfPatch<Mat2> by_pressure;    ///< dP_i/dp
  OfPatch<Mat2> pressure_rate;  ///< dp/dF_i, Pa
  OfPatch<PlasticState> updated;
};

/// The return of the trial strains of a patch.
struct PatchStep {
  double pressure = 0.0;  ///< p, Pa
  OfPatch<Branch> branch{};
  OfPatch<double> multiplier{};         ///< dgamma_i
  OfPatch<PlaneTensor> stress;          ///< Pa
  OfPatch<PlaneTensor> plastic_strain;  ///< increments
  OfPatch<PlaneTensor> direction;       ///< n_i, of the trial deviators
  OfPatch<Moduli> moduli;               ///< d(stress_i)/d(trial elastic strain_i) at constant p
  OfPatch<double> n_pressure{};         ///< d(stress_i) = (1 + n_pressure_i n_i) dp besides
  double by_volume = 0.0;               ///< dp = by_volume sum_i w_i tr(de_i) + sum_i by_shear_i n_i : de_i, Pa
  OfPatch<double> by_shear{};           ///< Pa
  PlasticWork work;                     ///< per undeformed volume of the patch
};
PatchStep patch_step(const DruckerPrager& material, const OfPatch<PlaneTensor>& trial_strain, const PatchPast& past);

}  // namespace cleft::constitutive
