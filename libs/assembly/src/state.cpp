#include "cleft/assembly/state.hpp"

namespace cleft::assembly {

State state_at_rest(const Model& model) {
  State state;
  state.displacement = VecX::Zero(model.unknowns.components());
  state.previous_displacement = state.displacement;
  state.contact = contact::memory_at_rest(model.surfaces);
  state.prescribed_force = VecX::Zero(static_cast<Eigen::Index>(constraints_of(model).size()));
  return state;
}

double elastic_energy(const Model& model, const VecX& displacement) {
  return std::visit(
      [&](const auto& law) {
        double sum = 0.0;
        for (const auto& cell : model.cells) sum += cell.area * law.energy(cell.deformation(displacement));
        return sum;
      },
      model.material);
}

}  // namespace cleft::assembly
