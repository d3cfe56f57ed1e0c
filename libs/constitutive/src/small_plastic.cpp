#include "cleft/constitutive/plastic.hpp"
#include "small_strain.hpp"
#include "stress_rate.hpp"

namespace cleft::constitutive {
namespace {

PlaneTensor elastic_strain(const Mat2& H, const PlasticState& state) {
  const auto& plastic = state.deformation;
  return plane_tensor(H(0, 0) - plastic[0], H(1, 1) - plastic[1], 0.5 * (H(0, 1) + H(1, 0)) - plastic[2], -plastic[3]);
}

}  // namespace

Response SmallPlastic::respond(const Mat2& gradient, const PlasticState& committed, PlasticState& updated,
                               double duration) const {
  const PlasticStep step = plastic_step(*this, elastic_strain(gradient, committed), committed.accumulated, duration);
  updated = committed;
  if (step.map.branch != Branch::Elastic) {
    const PlaneTensor& increment = step.plastic_strain;
    updated.deformation[0] += increment.centre + increment.radius[0];
    updated.deformation[1] += increment.centre - increment.radius[0];
    updated.deformation[2] += increment.radius[1];
    updated.deformation[3] += increment.normal;
    updated.accumulated += step.map.multiplier;
  }
  return {in_plane(step.stress), stress_rate(step.map.moduli, step.direction, {})};
}

double SmallPlastic::energy(const Mat2& gradient, const PlasticState& updated) const {
  return elastic_energy(constants, elastic_strain(gradient, updated));
}

PlasticWork SmallPlastic::dissipation(const Mat2& gradient, const PlasticState& committed, double duration) const {
  return plastic_step(*this, elastic_strain(gradient, committed), committed.accumulated, duration).work;
}

double SmallPlastic::out_of_plane_stress(const Mat2& gradient, const PlasticState& updated) const {
  return elastic_stress(constants, elastic_strain(gradient, updated)).normal;
}

ContinuumTangent SmallPlastic::continuum_tangent(const Mat2& gradient, const PlasticState& updated) const {
  const PlaneTensor strain = elastic_strain(gradient, updated);
  const Branch branch = branch_of(*this, elastic_stress(constants, strain), updated.accumulated);
  return {branch, stress_rate(continuum_moduli(*this, branch), unit_deviator(strain), {})};
}

}  // namespace cleft::constitutive
