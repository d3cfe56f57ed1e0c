#include "cleft/tangent_check/intermediate_states.hpp"

#include <algorithm>

namespace cleft::tangent_check {
namespace {

// Neither a converged state nor halfway, where a motion that turns back would stand still.
constexpr double kPart = 0.37;

IntermediateState between(const assembly::Model& model, const assembly::State& before, const VecX& after, double load) {
  return {model, before, before.displacement + kPart * (after - before.displacement),
          before.load + kPart * (load - before.load)};
}

// What one iteration makes of the last converged state on the way to the next load.
IntermediateState beyond(const solve::LoadStepper& stepper) {
  const assembly::State& state = stepper.state();
  const double load = std::min(1.0, state.load + stepper.place().step);
  solve::NewtonControls once;
  once.max_iterations = 1;
  once.extrapolate = false;
  assembly::Assembler assembler(stepper.model());
  solve::LinearSolver solver(solve::LoadStepper::factorisation_for(stepper.model()));
  const auto trial =
      solve::solve_increment({stepper.model(), stepper.constraints(), state, once, assembler, solver}, {load});
  return between(stepper.model(), state, trial.displacement, load);
}

}  // namespace

std::optional<assembly::Failure> visit_intermediate_states(growth::Evolution& body, int states,
                                                           const std::function<bool(const IntermediateState&)>& visit) {
  int visited = 0;  // of the loads (k + 1/2) / states
  const auto next = [&] { return (visited + 0.5) / states; };
  while (!body.done() && visited < states) {
    assembly::State before = body.stepper().state();
    const auto outcome = body.advance();
    if (const auto* failure = std::get_if<assembly::Failure>(&outcome)) {
      visit(beyond(body.stepper()));
      return *failure;
    }
    const assembly::State& after = body.stepper().state();
    if (!std::get<growth::Step>(outcome).advances.empty()) {
      if (!visit(between(body.model(), body.origin(), after.displacement, after.load))) break;
      continue;
    }
    before.history.duration = after.load - before.load;
    if (after.load < next()) continue;
    while (next() <= after.load) ++visited;
    if (!visit(between(body.model(), before, after.displacement, after.load))) break;
  }
  return std::nullopt;
}

}  // namespace cleft::tangent_check
