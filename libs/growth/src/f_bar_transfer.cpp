#include "f_bar_transfer.hpp"

#include <cmath>

#include "cleft/assembly/f_bar.hpp"
#include "cleft/constitutive/plastic_volume.hpp"

namespace cleft::growth {
namespace {

using assembly::Model, assembly::OfPatch;
using constitutive::PlasticState;
using Plastic = std::vector<PlasticState>;

// ln J that a law is asked at (small strain: the trace).
double volume(const Model& model, Index point, const VecX& displacement) {
  const Mat2 F = assembly::material_deformation(model, point, displacement);
  return model.is_small_strain() ? F.trace() : std::log(det(F));
}

// Adds so many times the volume of every point to its plastic volume, in the plane: Fbar is F times a number there.
void add_volume(const Model& model, const VecX& displacement, double times, Plastic& plastic) {
  assembly::for_each_run(model, [&]<class Law>(const Law& law, const assembly::PointRange& range) {
    if constexpr (constitutive::PathDependent<Law>)
      for (std::size_t p = range.first; p < range.last; ++p)
        swell_in_plane(law, plastic[p], times * volume(model, static_cast<Index>(p), displacement));
  });
}

bool has_flowed(const Model& model, const Plastic& plastic, std::size_t point) {
  const Index partner = point < model.f_bar_partner.size() ? model.f_bar_partner[point] : kNone;
  return plastic[point].accumulated > 0.0 || (partner != kNone && plastic[partner].accumulated > 0.0);
}

// The mean of both cells, for which alone their common pressure counts.
void share_volumes(const Model& model, Plastic& plastic) {
  for (const auto& patch : assembly::patches_of(model)) {
    const auto [a, b] = patch.cell;
    const double first = model.cells[a].area, second = model.cells[b].area;
    OfPatch<PlasticState> both{plastic[a], plastic[b]};
    std::visit(
        [&]<class Law>(const Law&) {
          if constexpr (constitutive::PathDependent<Law>)
            Law::share_volume(both, {first / (first + second), second / (first + second)});
        },
        model.material(a));
    plastic[a] = both[0];
    plastic[b] = both[1];
  }
}

}  // namespace

Plastic without_volume(const Model& model, const VecX& displacement, Plastic plastic) {
  if (!plastic.empty() && !model.f_bar_partner.empty()) add_volume(model, displacement, -1.0, plastic);
  return plastic;
}

Plastic with_volume(const Model& model, const VecX& displacement, Plastic plastic) {
  if (plastic.empty() || model.f_bar_partner.empty()) return plastic;
  add_volume(model, displacement, 1.0, plastic);
  share_volumes(model, plastic);
  for (std::size_t p = 0; p < plastic.size(); ++p)
    if (!has_flowed(model, plastic, p)) plastic[p] = {};
  return plastic;
}

}  // namespace cleft::growth
