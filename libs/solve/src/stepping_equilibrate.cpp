// The part of the stepper that finds the equilibrium of a body with new faces.
#include <algorithm>

#include "cleft/solve/stepping.hpp"

namespace cleft::solve {

std::variant<Step, assembly::Failure> LoadStepper::equilibrate(const IterationObserver& observer) {
  constexpr double kLeastPart = 1.0 / 1024;
  failed_attempts_.clear();
  const double unexplained = state_.energies.imbalance();
  if (auto failure = assembler_.assemble(state_.displacement, state_.history)) return *failure;
  VecX held = assembler_.internal_force() - dead_force(model_, state_.load);
  for (const auto& constraint : constraints_) held[constraint.component] = 0.0;
  int cuts = 0, iterations_before = 0;
  bool failed = false;  // since the last part
  for (double gone = 0.0, part = 1.0;;) {
    const double next = std::min(1.0, gone + part);
    const VecX still = (1.0 - next) / (1.0 - gone) * held;
    const Increment increment = solve({.load = state_.load, .held = &still}, observer);
    if (increment.failure) {
      ++cuts;
      failed = true;
      part *= 0.5;
      if (part >= kLeastPart) continue;
      assembly::Failure failure = *increment.failure;
      failure.attempt = assembly::HeldPart{state_.load, 1.0 - gone};
      return failure;
    }
    Step out = commit(increment);
    if (next < 1.0) {
      --place_.number;
      iterations_before += static_cast<int>(increment.iterations.size());
      held = still;
      gone = next;
      if (is_easy(increment) && !failed) part *= 2.0;
      failed = false;
      continue;
    }
    // theory (10.7)
    state_.energies.released += state_.energies.imbalance() - unexplained;
    end_account();
    out.cuts = cuts;
    out.iterations_before = iterations_before;
    return out;
  }
}

}  // namespace cleft::solve
