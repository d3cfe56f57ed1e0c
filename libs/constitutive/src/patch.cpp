#include "cleft/constitutive/patch.hpp"

#include <algorithm>
#include <cmath>

namespace cleft::constitutive {
namespace {

// Multiplier of a point as a function of the pressure, and its slope.
struct Flow {
  Branch branch = Branch::Elastic;
  double multiplier = 0.0, slope = 0.0;
};

// The numbers that decide the return.
struct Trial {
  double mean_pressure = 0.0;  // p_tr
  OfPatch<double> shear{};     // |s_tr|
  OfPatch<double> accumulated{};
};

double relief_of(const DruckerPrager& m) { return bulk_modulus(m.constants) * m.dilatancy; }

// Without resistance no pressure is beyond the apex: where it rounds to the far side, it is on it.
Flow flow_at(const DruckerPrager& m, double resistance, double shear, double accumulated, double pressure) {
  const bool resists = resistance > 0.0;
  const double beyond = yield_function(m, pressure, 0.0, accumulated),
               excess = shear + (resists ? beyond : std::min(beyond, 0.0));
  if (!(excess > 0.0) || std::isinf(resistance)) return {};
  const double stiffness = 2.0 * m.constants.mu + resistance;
  const Flow smooth{Branch::Smooth, excess / stiffness, m.friction / stiffness};
  if (!resists || !(2.0 * m.constants.mu * smooth.multiplier > shear)) return smooth;
  return {Branch::Apex, beyond / resistance, m.friction / resistance};
}

// Which part of the trial deviator flow removes.
double removed_by(const DruckerPrager& m, const Flow& flow, double shear) {
  if (flow.branch == Branch::Smooth) return std::min(2.0 * m.constants.mu * flow.multiplier / shear, 1.0);
  return flow.branch == Branch::Apex ? 1.0 : 0.0;
}

struct Flows {
  double pressure = 0.0;
  OfPatch<Flow> of;
  double stiffness = 1.0;  // d(p - p_tr + K b sum w dgamma)/dp; infinite on an apex that nothing hardens
};

// Both points on an apex at constant pressure.
Flows on_apex(const DruckerPrager& m, const Trial& trial, const PatchPast& past, double pressure) {
  Flows out{pressure, {}, kForever};
  double rest = (trial.mean_pressure - pressure) / relief_of(m);
  for (int i = 0; i < 2; ++i) {
    out.of[i] = {Branch::Apex, trial.shear[i] / (2.0 * m.constants.mu), 0.0};
    rest -= past.share[i] * out.of[i].multiplier;
  }
  for (auto& flow : out.of) flow.multiplier += std::max(rest, 0.0);
  return out;
}

// theory (5.12)
Flows common_return(const DruckerPrager& m, double resistance, const Trial& trial, const PatchPast& past) {
  Flows out{trial.mean_pressure, {}, 1.0};
  const bool bounded = resistance == 0.0 && m.friction > 0.0;
  const double apex = bounded ? m.cohesion / m.friction : kForever;
  out.pressure = std::min(out.pressure, apex);
  for (int piece = 0; piece < 6; ++piece) {
    double excess = out.pressure - trial.mean_pressure;
    out.stiffness = 1.0;
    for (int i = 0; i < 2; ++i) {
      out.of[i] = flow_at(m, resistance, trial.shear[i], trial.accumulated[i], out.pressure);
      excess += relief_of(m) * past.share[i] * out.of[i].multiplier;
      out.stiffness += relief_of(m) * past.share[i] * out.of[i].slope;
    }
    if (piece == 0 && excess < 0.0) return on_apex(m, trial, past, apex);
    const double next = out.pressure - excess / out.stiffness;
    if (!(next < out.pressure)) break;
    out.pressure = next;
  }
  return out;
}

// theory (5.13)
void add_rates(const DruckerPrager& m, double resistance, const Flows& flows, const Trial& trial, const PatchPast& past,
               PatchStep& out) {
  const double two_mu = 2.0 * m.constants.mu, by_shear = two_mu / (two_mu + resistance);
  out.by_volume = bulk_modulus(m.constants) / flows.stiffness;
  for (int i = 0; i < 2; ++i) {
    const Branch branch = flows.of[i].branch;
    if (branch == Branch::Apex) continue;
    const double removed = removed_by(m, flows.of[i], trial.shear[i]);
    const double mu = m.constants.mu * (1.0 - removed);
    out.moduli[i] = {.lambda = -2.0 / 3.0 * mu, .mu = mu};
    if (branch == Branch::Elastic) continue;
    out.moduli[i].n_n = two_mu * (removed - by_shear);
    out.n_pressure[i] = -m.friction * by_shear;
    out.by_shear[i] = -relief_of(m) / flows.stiffness * past.share[i] * by_shear;
  }
}

}  // namespace

PatchStep patch_step(const DruckerPrager& m, const OfPatch<PlaneTensor>& trial_strain, const PatchPast& past) {
  const double two_mu = 2.0 * m.constants.mu;
  const double drag = drag_of(m, past.duration), resistance = m.hardening + drag;
  Trial trial;
  OfPatch<PlaneTensor> shape;
  for (int i = 0; i < 2; ++i) {
    shape[i] = deviator(trial_strain[i]);
    trial.shear[i] = two_mu * std::sqrt(contract(shape[i], shape[i]));
    trial.accumulated[i] = past.state[i].accumulated;
    trial.mean_pressure += past.share[i] * (bulk_modulus(m.constants) * trace(trial_strain[i]));
  }
  const Flows flows = common_return(m, resistance, trial, past);
  PatchStep out;
  out.pressure = flows.pressure;
  add_rates(m, resistance, flows, trial, past, out);
  double mean = 0.0;
  for (int i = 0; i < 2; ++i) mean += past.share[i] * flows.of[i].multiplier;
  for (int i = 0; i < 2; ++i) {
    const double multiplier = flows.of[i].multiplier, size = trial.shear[i] / two_mu,
                 removed = removed_by(m, flows.of[i], trial.shear[i]);
    out.branch[i] = flows.of[i].branch;
    out.multiplier[i] = multiplier;
    if (size > 0.0) out.direction[i] = (1.0 / size) * shape[i];
    out.stress[i] = plus_identity((two_mu * (1.0 - removed)) * shape[i], out.pressure);
    out.plastic_strain[i] = plus_identity(removed * shape[i], m.dilatancy * mean / 3.0);
    const double viscous = multiplier > 0.0 ? drag * multiplier * multiplier : 0.0;
    out.work.viscous += past.share[i] * viscous;
    out.work.plastic +=
        past.share[i] * (multiplier * ((1.0 - removed) * trial.shear[i] + m.dilatancy * out.pressure) - viscous);
  }
  return out;
}

}  // namespace cleft::constitutive
