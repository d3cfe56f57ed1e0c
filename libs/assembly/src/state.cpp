#include "cleft/assembly/state.hpp"

namespace cleft::assembly {

State state_at_rest(const Model& model) {
  State state;
  state.displacement = VecX::Zero(model.unknowns.components());
  state.previous_displacement = state.displacement;
  state.history.contact = contact::memory_at_rest(model.surfaces);
  if (has_memory(model.material)) state.history.plastic.resize(model.cells.size());
  state.prescribed_force = VecX::Zero(static_cast<Eigen::Index>(constraints_of(model).size()));
  return state;
}

double elastic_energy(const Model& model, const VecX& displacement,
                      const std::vector<constitutive::PlasticState>& plastic) {
  return std::visit(
      [&]<class Law>(const Law& law) {
        double sum = 0.0;
        for (std::size_t c = 0; c < model.cells.size(); ++c) {
          const auto& cell = model.cells[c];
          const Mat2 F = cell.deformation(displacement);
          if constexpr (constitutive::PathDependent<Law>)
            sum += cell.area * law.energy(F, plastic[c]);
          else
            sum += cell.area * law.energy(F);
        }
        return sum;
      },
      model.material);
}

double plastic_dissipation(const Model& model, const VecX& displacement, const History& before) {
  return std::visit(
      [&]<class Law>(const Law& law) {
        double sum = 0.0;
        if constexpr (constitutive::PathDependent<Law>)
          for (std::size_t c = 0; c < model.cells.size(); ++c) {
            const auto& cell = model.cells[c];
            sum += cell.area * law.dissipation(cell.deformation(displacement), before.plastic[c]);
          }
        return sum;
      },
      model.material);
}

}  // namespace cleft::assembly
