#include "cleft/assembly/state.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "cleft/assembly/f_bar.hpp"

namespace cleft::assembly {

namespace {

std::array<double, 8> entries(const Energies& e) {
  return {e.external_work,
          e.elastic,
          e.contact,
          e.friction_dissipation,
          e.plastic_dissipation,
          e.viscous_dissipation,
          e.released,
          e.contact_pressure_work};
}

}  // namespace

double Energies::size() const {
  double out = 0.0;
  for (const double entry : entries(*this)) out = std::max(out, std::fabs(entry));
  return out;
}

double Energies::change(const Energies& since) const {
  const auto before = entries(since), now = entries(*this);
  double out = 0.0;
  for (std::size_t k = 0; k < now.size(); ++k) out += 0.5 * std::fabs(now[k] - before[k]);
  return out;
}

double farthest(const Model& model, const VecX& unknowns) {
  return unknowns.head(2 * model.unknowns.displacements()).cwiseAbs().maxCoeff();
}

void Energies::end_increment(double least) {
  largest = std::max(largest, size());
  if (std::fabs(imbalance()) > least) largest_imbalance = std::max(largest_imbalance, std::fabs(imbalance()));
}

State state_at_rest(const Model& model) {
  State state;
  state.displacement = VecX::Zero(model.unknowns.components());
  state.previous_displacement = state.displacement;
  state.history.contact = contact::contact_at_rest(model.surfaces);
  if (!model.surfaces.multiplier_space.empty())
    state.history.multipliers = contact::multipliers_at_rest(model.surfaces);
  if (model.has_memory()) state.history.plastic.resize(model.material_points());
  state.prescribed_force = VecX::Zero(static_cast<Eigen::Index>(constraints_of(model).size()));
  state.previous_prescribed_force = state.prescribed_force;
  return state;
}

double elastic_energy(const Model& model, const VecX& displacement,
                      const std::vector<constitutive::PlasticState>& plastic) {
  double sum = 0.0;
  for_each_run(model, [&]<class Law>(const Law& law, const PointRange& range) {
    for_each_material_point(model, range, [&](std::size_t p, const auto&, double weight) {
      const Mat2 F = material_deformation(model, static_cast<Index>(p), displacement);
      if constexpr (constitutive::PathDependent<Law>)
        sum += weight * law.energy(F, plastic[p]);
      else
        sum += weight * law.energy(F);
    });
  });
  for (const auto& tie : model.ties) sum += 0.5 * tie_stiffness(model, tie) * tie.jump(displacement).squaredNorm();
  return sum;
}

constitutive::PlasticWork plastic_dissipation(const Model& model, const VecX& displacement, const History& before) {
  constitutive::PlasticWork sum;
  const auto add = [&](const constitutive::PlasticWork& work, double weight) {
    sum.plastic += weight * work.plastic;
    sum.viscous += weight * work.viscous;
  };
  for_each_run(model, [&]<class Law>(const Law& law, const PointRange& range) {
    if constexpr (constitutive::PathDependent<Law>)
      for_each_material_point(model, range, [&](std::size_t p, const auto&, double weight) {
        const auto number = static_cast<Index>(p);
        const Index partner = p < model.f_bar_partner.size() ? model.f_bar_partner[p] : kNone;
        if (partner == kNone) {
          const Mat2 F = deformation(model, number, displacement);
          add(law.dissipation(F, before.plastic[p], before.duration), weight);
        } else if (number < partner) {
          const OfPatch<Index> cells{number, partner};
          const DeformedPatch patch = deformed(model, cells, displacement);
          add(law.dissipation(patch.strained, past_of(patch.share, cells, before.plastic, before.duration)),
              weight / patch.share[0]);
        }
      });
  });
  return sum;
}

}  // namespace cleft::assembly
