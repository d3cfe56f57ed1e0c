#include <cmath>

#include "cleft/constitutive/plastic_volume.hpp"
#include "small_strain.hpp"
#include "stress_rate.hpp"

namespace cleft::constitutive {
namespace {

PlaneTensor elastic_strain(const Mat2& H, const PlasticState& state) {
  const auto& plastic = state.deformation;
  return plane_tensor(H(0, 0) - plastic[0], H(1, 1) - plastic[1], 0.5 * (H(0, 1) + H(1, 0)) - plastic[2], -plastic[3]);
}

void add(const PlaneTensor& increment, PlasticState& state) {
  state.deformation[0] += increment.centre + increment.radius[0];
  state.deformation[1] += increment.centre - increment.radius[0];
  state.deformation[2] += increment.radius[1];
  state.deformation[3] += increment.normal;
}

PatchStep step_of(const DruckerPrager& material, const OfPatch<Mat2>& gradient, const PatchPast& past) {
  return patch_step(material, {elastic_strain(gradient[0], past.state[0]), elastic_strain(gradient[1], past.state[1])},
                    past);
}

}  // namespace

Response SmallPlastic::respond(const Mat2& gradient, const PlasticState& committed, PlasticState& updated,
                               double duration) const {
  const PlasticStep step = plastic_step(*this, elastic_strain(gradient, committed), committed.accumulated, duration);
  updated = committed;
  if (step.map.branch != Branch::Elastic) {
    add(step.plastic_strain, updated);
    updated.accumulated += step.map.multiplier;
  }
  return {in_plane(step.stress), stress_rate(step.map.moduli, step.direction, {})};
}

PatchResponse SmallPlastic::respond(const OfPatch<Mat2>& gradient, const PatchPast& past) const {
  const PatchStep step = step_of(*this, gradient, past);
  PatchResponse out;
  out.updated = past.state;
  for (int i = 0; i < 2; ++i) {
    const PlaneTensor& n = step.direction[i];
    out.piola[i] = in_plane(step.stress[i]);
    out.tangent[i] = stress_rate(step.moduli[i], n, {});
    out.by_pressure[i] = in_plane(plus_identity(step.n_pressure[i] * n, 1.0));
    out.pressure_rate[i] = step.by_shear[i] * in_plane(n) + past.share[i] * step.by_volume * Mat2::Identity();
    add(step.plastic_strain[i], out.updated[i]);
    out.updated[i].accumulated += step.multiplier[i];
  }
  return out;
}

void swell_in_plane(const SmallPlastic&, PlasticState& state, double by) {
  for (const int k : {0, 1}) state.deformation[k] += 0.5 * by;
}

void SmallPlastic::share_volume(OfPatch<PlasticState>& states, const OfPatch<double>& share) {
  const auto volume = [](const PlasticState& s) { return s.deformation[0] + s.deformation[1] + s.deformation[3]; };
  const double apart = (volume(states[1]) - volume(states[0])) / 3.0;
  for (const int k : {0, 1, 3}) {
    states[0].deformation[k] += share[1] * apart;
    states[1].deformation[k] -= share[0] * apart;
  }
}

double SmallPlastic::energy(const Mat2& gradient, const PlasticState& updated) const {
  return elastic_energy(constants, elastic_strain(gradient, updated));
}

PlasticWork SmallPlastic::dissipation(const Mat2& gradient, const PlasticState& committed, double duration) const {
  return plastic_step(*this, elastic_strain(gradient, committed), committed.accumulated, duration).work;
}

PlasticWork SmallPlastic::dissipation(const OfPatch<Mat2>& gradient, const PatchPast& past) const {
  return step_of(*this, gradient, past).work;
}

double SmallPlastic::out_of_plane_stress(const Mat2& gradient, const PlasticState& updated) const {
  return elastic_stress(constants, elastic_strain(gradient, updated)).normal;
}

bool SmallPlastic::is_on_apex(const Mat2& gradient, const PlasticState& updated) const {
  const PlaneTensor shape = deviator(elastic_strain(gradient, updated));
  return friction > 0.0 && std::sqrt(contract(shape, shape)) <= kRoundedStrain * (1.0 + gradient.norm());
}

ContinuumTangent SmallPlastic::continuum_tangent(const Mat2& gradient, const PlasticState& updated) const {
  const PlaneTensor strain = elastic_strain(gradient, updated);
  const Branch branch = branch_of(*this, elastic_stress(constants, strain), updated.accumulated);
  return {branch, stress_rate(continuum_moduli(*this, branch), unit_deviator(strain), {})};
}

}  // namespace cleft::constitutive
