#include "arc_length.hpp"

#include <algorithm>
#include <cmath>

#include "cleft/solve/stepping.hpp"

namespace cleft::solve {

// theory (9.3)
VecX path_progress(const assembly::Model& model, const assembly::State& before, const VecX& displacement,
                   const std::vector<constitutive::PlasticState>& plastic) {
  const VecX moved = displacement - before.displacement;
  const auto flow = [&](std::size_t p) { return plastic[p].accumulated - before.history.plastic[p].accumulated; };
  bool flows = false;
  for (std::size_t p = 0; p < plastic.size() && !flows; ++p) flows = flow(p) > 0.0;

  VecX progress = VecX::Zero(displacement.size());
  double grown = 0.0;
  for_each_material_point(model, [&](std::size_t p, const auto& point, double weight) {
    const double share = flows ? weight * flow(p) : weight;
    if (!(share > 0.0)) return;
    const Mat2 D = assembly::displacement_gradient(point, moved);
    grown += share * D.squaredNorm();
    for (std::size_t k = 0; k < point.unknown.size(); ++k)
      progress.segment<2>(2 * point.unknown[k]) += share * (D * point.gradient[k]);
  });
  if (!(grown > 0.0)) return {};
  return progress / grown;
}

double last_motion(const assembly::Model& model, const assembly::State& state) {
  return farthest(model, state.displacement - state.previous_displacement);
}

double unexplained_part(const assembly::Energies& before, const assembly::Energies& after, double least) {
  constexpr double kOfLargest = 2e-3;
  const double missed = std::fabs(after.imbalance() - before.imbalance());
  const bool counts = before.largest > 0.0 && missed > std::max(least, kOfLargest * after.largest);
  return counts ? missed / after.change(before) : 0.0;
}

bool unloads_elastically(const assembly::State& before, const std::vector<constitutive::PlasticState>& plastic,
                         double load, Determinant determinant) {
  if (determinant != Determinant::Positive || load >= before.load) return false;
  const auto& past = before.history.plastic;
  bool flowed = false;
  for (std::size_t p = 0; p < plastic.size(); ++p) {
    if (plastic[p].accumulated > past[p].accumulated) return false;
    flowed = flowed || past[p].accumulated > 0.0;
  }
  return flowed;
}

void Plateau::follow(double now, double moved, double come) {
  constexpr double kSame = 1e-4;
  if (std::fabs(now - load) > kSame * std::fabs(load))
    *this = {now, come, 0.0};
  else
    travelled += moved;
}

bool Plateau::goes_on() const { return extent > 0.0 && travelled >= extent; }

}  // namespace cleft::solve
