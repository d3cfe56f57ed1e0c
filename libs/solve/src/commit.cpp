#include "commit.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "commit_contact.hpp"

namespace cleft::solve {
namespace {

void commit_bulk(const Converged& c, assembly::State& state) {
  auto& energies = state.energies;
  energies.elastic = elastic_energy(c.model, c.increment.displacement, c.assembler.plastic());
  const auto work = plastic_dissipation(c.model, c.increment.displacement, state.history);
  energies.plastic_dissipation += work.plastic;
  energies.viscous_dissipation += work.viscous;
  state.history.plastic = c.assembler.plastic();
}

// Forces on the body at the constraints, N/m.
VecX prescribed_force(const Converged& c) {
  const VecX force = c.assembler.internal_force() - dead_force(c.model, c.increment.load);
  VecX out(c.constraints.size());
  for (std::size_t k = 0; k < c.constraints.size(); ++k) out[k] = force[c.constraints[k].component];
  return out;
}

// By the trapezoidal rule.
void add_external_work(const Converged& c, const VecX& prescribed, assembly::State& state) {
  const VecX& displacement = c.increment.displacement;
  double& work = state.energies.external_work;
  for (std::size_t k = 0; k < c.constraints.size(); ++k) {
    const Index i = c.constraints[k].component;
    work += 0.5 * (prescribed[k] + state.prescribed_force[k]) * (displacement[i] - state.displacement[i]);
  }
  work +=
      0.5 *
      (dead_force(c.model, c.increment.load) + dead_force(c.model, state.load)).dot(displacement - state.displacement);
}

void advance_state(const Increment& increment, VecX prescribed, assembly::State& state) {
  state.previous_prescribed_force = std::exchange(state.prescribed_force, std::move(prescribed));
  state.largest_force = std::max(state.largest_force, increment.force);
  state.previous_load = std::exchange(state.load, increment.load);
  state.previous_displacement = std::exchange(state.displacement, increment.displacement);
}

}  // namespace

void commit_increment(const Converged& converged, assembly::State& state) {
  const auto& assembler = converged.assembler;
  commit_bulk(converged, state);
  commit_contact(converged.model, assembler, state.displacement, assembler.pairs(), state.history, state.energies);
  VecX prescribed = prescribed_force(converged);
  add_external_work(converged, prescribed, state);
  advance_state(converged.increment, std::move(prescribed), state);
}

double rounding_of_energy(const assembly::Model& model, const VecX& displacement) {
  constexpr double kRounding = 1e2 * std::numeric_limits<double>::epsilon();
  const double moved = farthest(model, displacement);
  return kRounding * model.stiffness() * moved * moved;
}

}  // namespace cleft::solve
