#include <algorithm>
#include <cmath>

#include "cleft/constitutive/logarithm.hpp"
#include "cleft/constitutive/plastic_volume.hpp"
#include "stress_rate.hpp"

namespace cleft::constitutive {
namespace {

struct ElasticDeformation {
  double centre = 1.0;  // of the Mohr circle of b^e
  CircleShape shape;
  PlaneTensor strain;  // (1/2) ln b^e
};

Mat2 plane_part(const PlasticState& state) {
  const auto& s = state.deformation;
  Mat2 m;
  m << s[0], s[2], s[2], s[1];
  return m;
}

// ln det(1 + a)
double log_det_of_one_plus(const Mat2& a) { return std::log1p(a(0, 0) + a(1, 1) + det(a)); }

// b^e - 1 in the plane, from differences to 1 that keep the digits of small strains.
Mat2 elastic_offset(const Mat2& F, const PlasticState& state) {
  const Mat2 H = F - Mat2::Identity();
  return H + H.transpose() + H * H.transpose() + F * plane_part(state) * F.transpose();
}

// theory (5.3), from b^e - 1, which for small strains of both kinds keeps the digits that b^e would round away.
ElasticDeformation elastic_deformation(const Mat2& F, const PlasticState& state) {
  const Mat2 H = F - Mat2::Identity(), plastic = plane_part(state);
  const Mat2 offset = elastic_offset(F, state);
  ElasticDeformation e;
  e.centre = 1.0 + 0.5 * (offset(0, 0) + offset(1, 1));
  e.shape.w = Vec2(0.5 * (offset(0, 0) - offset(1, 1)), 0.5 * (offset(0, 1) + offset(1, 0))) / e.centre;
  const double r = e.shape.w.squaredNorm();
  e.shape.remainder = atanh_remainder(r);
  e.strain.centre = 0.5 * log_det_of_one_plus(H) + 0.25 * log_det_of_one_plus(plastic);
  e.strain.radius = (0.5 * (1.0 + r * e.shape.remainder)) * e.shape.w;
  e.strain.normal = 0.5 * std::log1p(state.deformation[3]);
  return e;
}

// exp(-2 increment) - 1
PlaneTensor relaxation_of(const PlaneTensor& increment) {
  const double size = 2.0 * increment.radius.norm();
  const double half_sinh = std::sinh(0.5 * size), scale = std::exp(-2.0 * increment.centre);
  const double sinh_quotient = size > 0.0 ? std::sinh(size) / size : 1.0;
  return {std::expm1(-2.0 * increment.centre) + 2.0 * scale * half_sinh * half_sinh,
          (-2.0 * scale * sinh_quotient) * increment.radius, std::expm1(-2.0 * increment.normal)};
}

Mat2 inverse(const Mat2& a) {
  Mat2 m;
  m << a(1, 1), -a(0, 1), -a(1, 0), a(0, 0);
  return m / det(a);
}

// theory (5.3): C^p^-1 moves by F^-1 (b^e - b^e_trial) F^-T, so that small increments are added and not differences of
// large numbers.
void relax(PlasticState& state, const Mat2& F_inverse, const ElasticDeformation& trial, const PlaneTensor& increment) {
  const PlaneTensor x = relaxation_of(increment);
  const Vec2& w = trial.shape.w;
  const PlaneTensor change =
      trial.centre * PlaneTensor{.centre = x.centre + w.dot(x.radius),  // product of coaxial tensors
                                 .radius = x.radius + x.centre * w};
  const Mat2 pulled = F_inverse * in_plane(change) * F_inverse.transpose();
  state.deformation[0] += pulled(0, 0);
  state.deformation[1] += pulled(1, 1);
  state.deformation[2] += 0.5 * (pulled(0, 1) + pulled(1, 0));
  state.deformation[3] += (1.0 + state.deformation[3]) * x.normal;
}

std::array<double, 4> components(const PlaneTensor& a) {
  return {a.centre + a.radius[0], a.centre - a.radius[0], a.radius[1], a.normal};
}

// With (1/2) ln C_p^-1, the elastic strain at F = 1, for the plastic deformation; and back.
PlasticState logarithm_of(PlasticState state) {
  state.deformation = components(elastic_deformation(Mat2::Identity(), state).strain);
  return state;
}
PlasticState exponential_of(PlasticState logarithm) {
  const auto& a = logarithm.deformation;
  logarithm.deformation = components(relaxation_of(plane_tensor(-a[0], -a[1], -a[2], -a[3])));
  return logarithm;
}

// C_p^-1 - 1 where C_p^-1 grows by e^by in every direction of the plane, or of space.
void grow_in_plane(PlasticState& state, double by) {
  const double factor = std::expm1(by);
  for (const int k : {0, 1}) state.deformation[k] += factor * (1.0 + state.deformation[k]);
  state.deformation[2] += factor * state.deformation[2];
}
void grow(PlasticState& state, double by) {
  grow_in_plane(state, by);
  state.deformation[3] += std::expm1(by) * (1.0 + state.deformation[3]);
}

// a_ijkl - tau_il delta_jk of theory (1.5)
Mat4 with_geometric_part(Mat4 rate, const Mat2& tau) {
  for (int j = 0; j < 2; ++j)
    for (int l = 0; l < 2; ++l) rate.block<2, 1>(2 * j, j + 2 * l) -= tau.col(l);
  return rate;
}

// c_ijkl F^-1_Jj F^-1_Ll
Mat4 pull_back(const Mat4& c, const Mat2& F_inverse) {
  Mat4 half, whole;
  for (int l = 0; l < 2; ++l)
    half.middleCols<2>(2 * l) = c.leftCols<2>() * F_inverse(l, 0) + c.rightCols<2>() * F_inverse(l, 1);
  for (int j = 0; j < 2; ++j)
    whole.middleRows<2>(2 * j) = F_inverse(j, 0) * half.topRows<2>() + F_inverse(j, 1) * half.bottomRows<2>();
  return whole;
}

// What a linear function of g = dF F^-1 is of dF.
Mat2 pull_back_rate(const Eigen::RowVector4d& rate, const Mat2& F_inverse) {
  return Eigen::Map<const Mat2>(rate.data()) * F_inverse.transpose();
}

struct PatchTrial {
  OfPatch<ElasticDeformation> elastic;
  PatchStep step;
};
PatchTrial trial_of(const DruckerPrager& material, const OfPatch<Mat2>& deformation, const PatchPast& past) {
  const OfPatch<ElasticDeformation> e{elastic_deformation(deformation[0], past.state[0]),
                                      elastic_deformation(deformation[1], past.state[1])};
  return {e, patch_step(material, {e[0].strain, e[1].strain}, past)};
}

}  // namespace

Response FinitePlastic::respond(const Mat2& deformation, const PlasticState& committed, PlasticState& updated,
                                double duration) const {
  const ElasticDeformation trial = elastic_deformation(deformation, committed);
  const PlasticStep step = plastic_step(*this, trial.strain, committed.accumulated, duration);
  const Mat2 F_inverse = inverse(deformation), tau = in_plane(step.stress);
  updated = committed;
  if (step.map.branch != Branch::Elastic) {
    relax(updated, F_inverse, trial, step.plastic_strain);
    updated.accumulated += step.map.multiplier;
  }
  const Mat4 rate = stress_rate(step.map.moduli, step.direction, trial.shape);
  return {tau * F_inverse.transpose(), pull_back(with_geometric_part(rate, tau), F_inverse)};
}

PatchResponse FinitePlastic::respond(const OfPatch<Mat2>& deformation, const PatchPast& past) const {
  const auto [elastic, step] = trial_of(*this, deformation, past);
  const bool flows = step.branch[0] != Branch::Elastic || step.branch[1] != Branch::Elastic;
  PatchResponse out;
  out.updated = past.state;
  for (int i = 0; i < 2; ++i) {
    const PlaneTensor& n = step.direction[i];
    const Mat2 F_inverse = inverse(deformation[i]), tau = in_plane(step.stress[i]);
    const Mat4 rate = stress_rate(step.moduli[i], n, elastic[i].shape);
    out.piola[i] = tau * F_inverse.transpose();
    out.tangent[i] = pull_back(with_geometric_part(rate, tau), F_inverse);
    out.by_pressure[i] = in_plane(plus_identity(step.n_pressure[i] * n, 1.0)) * F_inverse.transpose();
    out.pressure_rate[i] = pull_back_rate(
        step.by_shear[i] * rate_along(n, elastic[i].shape) + past.share[i] * step.by_volume * volume_rate(), F_inverse);
    if (!flows) continue;
    relax(out.updated[i], F_inverse, elastic[i], step.plastic_strain[i]);
    out.updated[i].accumulated += step.multiplier[i];
  }
  return out;
}

double FinitePlastic::energy(const Mat2& deformation, const PlasticState& updated) const {
  return elastic_energy(constants, elastic_deformation(deformation, updated).strain);
}

PlasticWork FinitePlastic::dissipation(const Mat2& deformation, const PlasticState& committed, double duration) const {
  const PlaneTensor trial = elastic_deformation(deformation, committed).strain;
  return plastic_step(*this, trial, committed.accumulated, duration).work;
}

PlasticWork FinitePlastic::dissipation(const OfPatch<Mat2>& deformation, const PatchPast& past) const {
  return trial_of(*this, deformation, past).step.work;
}

double FinitePlastic::out_of_plane_stress(const Mat2& deformation, const PlasticState& updated) const {
  return elastic_stress(constants, elastic_deformation(deformation, updated).strain).normal;
}

ContinuumTangent FinitePlastic::continuum_tangent(const Mat2& deformation, const PlasticState& updated) const {
  const ElasticDeformation e = elastic_deformation(deformation, updated);
  const PlaneTensor tau = elastic_stress(constants, e.strain);
  const Branch branch = branch_of(*this, tau, updated.accumulated);
  const Mat4 rate = stress_rate(continuum_moduli(*this, branch), unit_deviator(e.strain), e.shape);
  return {branch, with_geometric_part(rate, in_plane(tau))};
}

bool FinitePlastic::is_on_apex(const Mat2& deformation, const PlasticState& updated) const {
  const Mat2 b = elastic_offset(deformation, updated);
  const double largest = std::max(
      {std::fabs(b(0, 0) - b(1, 1)), std::fabs(b(0, 1) + b(1, 0)), std::fabs(b(0, 0) - updated.deformation[3])});
  return friction > 0.0 && largest <= kRoundedStrain * (1.0 + std::fabs(b(0, 0)));
}

// theory (10.10)
PlasticState FinitePlastic::mean(std::span<const WeightedState> states) {
  const auto same = [&](const WeightedState& other) { return other.state == states.front().state; };
  if (std::ranges::all_of(states, same)) return linear_mean(states);
  return exponential_of(linear_mean(states, logarithm_of));
}

void swell_in_plane(const FinitePlastic&, PlasticState& state, double by) { grow_in_plane(state, -by); }

void FinitePlastic::share_volume(OfPatch<PlasticState>& states, const OfPatch<double>& share) {
  const auto volume = [](const PlasticState& s) {
    return log_det_of_one_plus(plane_part(s)) + std::log1p(s.deformation[3]);
  };
  const double apart = (volume(states[1]) - volume(states[0])) / 3.0;
  grow(states[0], share[1] * apart);
  grow(states[1], -share[0] * apart);
}

}  // namespace cleft::constitutive
