/// \file
/// The cone of Drucker and Prager with non-associated flow, the J2 cylinder as its special case, and the return to it.
///
/// With p = tr(stress)/3 (positive in tension), s its deviator, |s| = sqrt(s : s) (Liu and Borja 2010, (95)):
///
///     yield      |s| + beta p - alpha(gamma) = 0,     alpha(gamma) = cohesion + hardening gamma
///     potential  |s| + b p
///     flow       plastic strain increment = dgamma (s/|s| + b/3 1)
///
/// The elastic law is isotropic and linear, p = K tr(e), s = 2 mu dev(e), in the elastic strain e: the logarithmic one
/// and Kirchhoff stress at finite strain, the linearised one and Cauchy stress at small strain. The return is then
/// radial in the deviatoric plane and needs two numbers of the trial stress only, p_tr and |s_tr|:
///
///     smooth   dgamma = (|s_tr| + beta p_tr - alpha)/(2 mu + K beta b + H),
///              p = p_tr - K b dgamma,   s = (1 - 2 mu dgamma/|s_tr|) s_tr
///     apex     where that factor is negative: s = 0, p = alpha(gamma + dgamma)/beta
///
/// On the apex the direction of flow is any of the apex's cone of normals, and only its volumetric part is known, which
/// stays b dgamma: the multiplier is the one that hardens alpha by H dgamma while the pressure falls by K b dgamma,
///
///     beta (p_tr - K b dgamma) = alpha + H dgamma,   i.e.   dgamma = (beta p_tr - alpha)/(K beta b + H),
///
/// and agrees with the smooth one where the two regions of the trial stress meet (|s_tr| = 2 mu dgamma there).
///
/// Viscosity after Perzyna lets the stress leave the cone by a measure of the rate of flow, f = viscosity dgamma/dt.
/// Over a step of the duration dt it joins H in the denominators of both multipliers as viscosity/dt.
#pragma once

#include <limits>

#include "cleft/constitutive/elastic.hpp"
#include "cleft/constitutive/plane_tensor.hpp"

namespace cleft::constitutive {

struct DruckerPrager {
  Lame constants;
  double cohesion = 0.0;   ///< alpha at gamma = 0, Pa
  double friction = 0.0;   ///< beta, not negative; 0 is J2
  double dilatancy = 0.0;  ///< b
  double hardening = 0.0;  ///< H = d alpha/d gamma, Pa
  double viscosity = 0.0;  ///< Pa times the unit of time
};

/// A duration that no viscosity notices.
inline constexpr double kForever = std::numeric_limits<double>::infinity();

/// J2 plasticity: uniaxial yield stress sigma_y and uniaxial hardening modulus d sigma_y / d(equivalent plastic
/// strain), both in Pa. alpha = sqrt(2/3) sigma_y, and since the equivalent plastic strain is sqrt(2/3) gamma, H is two
/// thirds of the uniaxial modulus.
DruckerPrager von_mises(const Lame& constants, double yield_stress, double hardening_modulus = 0.0);

/// Whether every trial stress has a return: no softening, a cohesion that is not negative (J2: positive), and a cone
/// that dilates. Without dilatancy no plastic strain relieves the pressure, and the apex is out of reach (perfect
/// plasticity) or comes to the stress by hardening without plastic strain.
bool always_returns(const DruckerPrager& material);

/// What viscosity adds to hardening over a step, Pa: viscosity/duration; infinite over a step of no duration.
double drag_of(const DruckerPrager& material, double duration);

/// |s| + beta p - alpha(accumulated), Pa: negative inside.
double yield_function(const DruckerPrager& material, double pressure, double shear, double accumulated);

enum class Branch { Elastic, Smooth, Apex };

/// A deviatoric strain that is rounding.
inline constexpr double kRoundedStrain = 1e-13;

/// A tangent d(stress) = lambda tr(de) 1 + 2 mu de + (one_n 1 + n_n n)(n : de) + n_one tr(de) n, all in Pa, where n is
/// a deviatoric unit tensor: the direction of the trial deviator.
struct Moduli {
  double lambda = 0.0, mu = 0.0;
  double one_n = 0.0, n_one = 0.0, n_n = 0.0;
};

/// Where the return ends, from the two invariants of the trial stress.
struct Return {
  Branch branch = Branch::Elastic;
  double multiplier = 0.0;  ///< dgamma
  double pressure = 0.0;    ///< p, Pa
  double removed = 0.0;     ///< s = (1 - removed) s_tr: 0 elastic, 1 on the apex
  Moduli moduli;            ///< d(stress)/d(trial elastic strain), the derivative of this very map
};

/// The return map. `pressure` is p_tr, `shear` is |s_tr|, `accumulated` the gamma at the begin of the step.
Return return_to_cone(const DruckerPrager& material, double pressure, double shear, double accumulated,
                      double duration = kForever);

/// Moduli of continued flow, the limit of small steps: at a stress on the cone, or on its apex.
Moduli continuum_moduli(const DruckerPrager& material, Branch branch);

/// What a step dissipates per unit reference volume, J/m^3: stress times plastic strain increment, dgamma (|s| + b p),
/// in two parts.
struct PlasticWork {
  double plastic = 0.0;  ///< that of a stress on the cone
  double viscous = 0.0;  ///< that of the distance from it, viscosity/dt dgamma^2
};

/// The return of a tensor.
struct PlasticStep {
  Return map;
  PlaneTensor stress;          ///< Pa
  PlaneTensor plastic_strain;  ///< increment of the step; zero if elastic
  PlaneTensor direction;       ///< n of the moduli; zero for a hydrostatic trial stress
  PlasticWork work;
};
PlasticStep plastic_step(const DruckerPrager& material, const PlaneTensor& trial_strain, double accumulated,
                         double duration = kForever);

/// Which branch a stress at rest belongs to: smooth or apex if it has flowed before and is on the cone, to 1e-9 of the
/// largest term of the yield function (or to the rounding of strains of order one), or beyond it; else elastic.
Branch branch_of(const DruckerPrager& material, const PlaneTensor& stress, double accumulated);

/// lambda tr(e) 1 + 2 mu e, Pa.
PlaneTensor elastic_stress(const Lame& constants, const PlaneTensor& elastic_strain);

/// lambda/2 tr(e)^2 + mu e : e, J/m^3.
double elastic_energy(const Lame& constants, const PlaneTensor& elastic_strain);

}  // namespace cleft::constitutive
