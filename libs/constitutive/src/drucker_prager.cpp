#include "cleft/constitutive/drucker_prager.hpp"

#include <algorithm>
#include <cmath>

namespace cleft::constitutive {
namespace {

// Denominators of the two multipliers: the stiffness against which the plastic strain acts.
double apex_stiffness(const DruckerPrager& m, double drag) {
  return bulk_modulus(m.constants) * m.friction * m.dilatancy + m.hardening + drag;
}
double smooth_stiffness(const DruckerPrager& m, double drag) { return 2.0 * m.constants.mu + apex_stiffness(m, drag); }

// theory (5.7): the derivative of the smooth return, s = (1 - removed) s_tr; continued flow is removed = 0.
Moduli smooth_moduli(const DruckerPrager& m, double removed, double drag) {
  const double K = bulk_modulus(m.constants), two_mu = 2.0 * m.constants.mu;
  const double by_shear = 1.0 / smooth_stiffness(m, drag);  // d dgamma / d|s_tr|
  const double by_pressure = m.friction * by_shear;         // d dgamma / d p_tr
  const double mu = m.constants.mu * (1.0 - removed);
  return {.lambda = K * (1.0 - K * m.dilatancy * by_pressure) - 2.0 / 3.0 * mu,
          .mu = mu,
          .one_n = -K * m.dilatancy * two_mu * by_shear,
          .n_one = -K * two_mu * by_pressure,
          .n_n = two_mu * (removed - two_mu * by_shear)};
}

Moduli apex_moduli(const DruckerPrager& m, double drag) {
  return {.lambda = bulk_modulus(m.constants) * (m.hardening + drag) / apex_stiffness(m, drag)};
}

}  // namespace

DruckerPrager von_mises(const Lame& constants, double yield_stress, double hardening_modulus) {
  return {.constants = constants,
          .cohesion = std::sqrt(2.0 / 3.0) * yield_stress,
          .hardening = 2.0 / 3.0 * hardening_modulus};
}

bool always_returns(const DruckerPrager& m) {
  if (!(m.hardening >= 0.0)) return false;
  if (m.friction == 0.0) return m.cohesion > 0.0 && m.dilatancy >= 0.0;
  return m.friction > 0.0 && m.cohesion >= 0.0 && m.dilatancy > 0.0;
}

double drag_of(const DruckerPrager& m, double duration) { return m.viscosity > 0.0 ? m.viscosity / duration : 0.0; }

// theory (5.1)
double yield_function(const DruckerPrager& m, double pressure, double shear, double accumulated) {
  return shear + m.friction * pressure - (m.cohesion + m.hardening * accumulated);
}

// theory (5.4), (5.5)
Return return_to_cone(const DruckerPrager& m, double pressure, double shear, double accumulated, double duration) {
  Return out;
  const double drag = drag_of(m, duration);
  const double excess = yield_function(m, pressure, shear, accumulated);
  if (!(excess > 0.0) || std::isinf(drag)) {
    out.pressure = pressure;
    out.moduli = {.lambda = m.constants.lambda, .mu = m.constants.mu};
    return out;
  }
  out.branch = Branch::Smooth;
  out.multiplier = excess / smooth_stiffness(m, drag);
  if (2.0 * m.constants.mu * out.multiplier <= shear) {
    out.removed = 2.0 * m.constants.mu * out.multiplier / shear;
    out.moduli = smooth_moduli(m, out.removed, drag);
  } else {
    out.branch = Branch::Apex;
    out.multiplier = yield_function(m, pressure, 0.0, accumulated) / apex_stiffness(m, drag);
    out.removed = 1.0;
    out.moduli = apex_moduli(m, drag);
  }
  out.pressure = pressure - bulk_modulus(m.constants) * m.dilatancy * out.multiplier;
  return out;
}

Moduli continuum_moduli(const DruckerPrager& m, Branch branch) {
  switch (branch) {
    case Branch::Smooth:
      return smooth_moduli(m, 0.0, 0.0);
    case Branch::Apex:
      return apex_moduli(m, 0.0);
    case Branch::Elastic:
      break;
  }
  return {.lambda = m.constants.lambda, .mu = m.constants.mu};
}

// theory (5.2), (5.9)
PlasticStep plastic_step(const DruckerPrager& m, const PlaneTensor& trial_strain, double accumulated, double duration) {
  const PlaneTensor shape = deviator(trial_strain);
  const double size = std::sqrt(contract(shape, shape)), two_mu = 2.0 * m.constants.mu;
  PlasticStep out;
  out.map = return_to_cone(m, bulk_modulus(m.constants) * trace(trial_strain), two_mu * size, accumulated, duration);
  if (size > 0.0) out.direction = (1.0 / size) * shape;
  if (out.map.branch == Branch::Elastic) {
    out.stress = elastic_stress(m.constants, trial_strain);
    return out;
  }
  const double kept = 1.0 - out.map.removed;
  out.stress = plus_identity((two_mu * kept) * shape, out.map.pressure);
  out.plastic_strain = plus_identity(out.map.removed * shape, m.dilatancy * out.map.multiplier / 3.0);
  const double overstress = drag_of(m, duration) * out.map.multiplier;
  out.work.viscous = overstress * out.map.multiplier;
  out.work.plastic = out.map.multiplier * (two_mu * kept * size + m.dilatancy * out.map.pressure) - out.work.viscous;
  return out;
}

Branch branch_of(const DruckerPrager& m, const PlaneTensor& stress, double accumulated) {
  if (!(accumulated > 0.0)) return Branch::Elastic;
  const PlaneTensor s = deviator(stress);
  const double pressure = trace(stress) / 3.0, shear = std::sqrt(contract(s, s));
  const double strength = m.cohesion + m.hardening * accumulated;
  const double tolerance = std::max(1e-9 * std::max({strength, shear, std::abs(m.friction * pressure)}),
                                    1e-14 * uniaxial_strain_modulus(m.constants));
  if (!(yield_function(m, pressure, shear, accumulated) >= -tolerance)) return Branch::Elastic;
  return shear <= tolerance ? Branch::Apex : Branch::Smooth;
}

PlaneTensor elastic_stress(const Lame& c, const PlaneTensor& elastic_strain) {
  return plus_identity((2.0 * c.mu) * elastic_strain, c.lambda * trace(elastic_strain));
}

double elastic_energy(const Lame& c, const PlaneTensor& elastic_strain) {
  const double volume = trace(elastic_strain);
  return 0.5 * c.lambda * volume * volume + c.mu * contract(elastic_strain, elastic_strain);
}

}  // namespace cleft::constitutive
