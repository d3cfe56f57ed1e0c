#include "cleft/tangent_check/intermediate_states.hpp"

#include <algorithm>

namespace cleft::tangent_check {
namespace {

// Neither a converged state nor halfway, where a motion that turns back would stand still.
constexpr double kPart = 0.37;

using Of = IntermediateState::Of;

IntermediateState between(const assembly::Model& model, const assembly::State& before, const VecX& after, double load,
                          Of of) {
  return {model,
          before,
          before.displacement + kPart * (after - before.displacement),
          before.load + kPart * (load - before.load),
          load,
          of};
}

// What one iteration makes of the last converged state on the way to the next load.
VecX after_one_iteration(const solve::LoadStepper& stepper, const assembly::State& state, double load) {
  solve::NewtonControls once;
  once.max_iterations = 1;
  once.extrapolate = false;
  assembly::Assembler assembler(stepper.model());
  solve::LinearSolver solver(solve::LoadStepper::factorisation_for(stepper.model()));
  return solve::solve_increment({stepper.model(), stepper.constraints(), state, once, assembler, solver}, {load})
      .displacement;
}

void visit_failure(const solve::LoadStepper& stepper, const StateVisitor& visit) {
  assembly::State state = stepper.state();
  const double load = std::min(1.0, state.load + stepper.place().step);
  state.history.duration = load - state.load;
  visit(between(stepper.model(), state, after_one_iteration(stepper, state, load), load, Of::Failure));
}

}  // namespace

std::optional<assembly::Failure> visit_increments(growth::Evolution& body, const StateVisitor& visit) {
  while (!body.done()) {
    assembly::State before = body.stepper().state();
    const auto outcome = body.advance();
    if (const auto* failure = std::get_if<assembly::Failure>(&outcome)) {
      visit_failure(body.stepper(), visit);
      return *failure;
    }
    const assembly::State& after = body.stepper().state();
    const bool grown = !std::get<growth::Step>(outcome).advances.empty();
    assembly::State from = grown ? body.origin() : std::move(before);
    from.history.duration = after.load - from.load;
    if (!visit(between(body.model(), from, after.displacement, after.load, grown ? Of::Growth : Of::Increment))) break;
  }
  return std::nullopt;
}

bool EvenlyOverLoad::takes(const IntermediateState& state) {
  if (state.of != Of::Increment) return true;
  if (taken_ >= states_ || state.after < next()) return false;
  while (next() <= state.after) ++taken_;
  return true;
}

}  // namespace cleft::tangent_check
