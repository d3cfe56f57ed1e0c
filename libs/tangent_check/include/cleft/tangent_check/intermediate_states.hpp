/// \file
/// States between the converged ones of a run.
#pragma once

#include <functional>

#include "cleft/growth/evolution.hpp"

namespace cleft::tangent_check {

/// Part of the way from one converged state to the next, with the history of the first: contact points that slide do so
/// in earnest, and none that sticks has just reached its limit.
struct IntermediateState {
  /// Between converged states of two loads; from the state that grown cracks were cut through; along the first
  /// correction of an increment that failed.
  enum class Of : std::uint8_t { Increment, Growth, Failure };

  const assembly::Model& model;
  const assembly::State& before;  ///< the first of the two converged states; its duration is that of the increment
  VecX displacement;              ///< metres, all components
  double load = 0.0;
  double after = 0.0;  ///< load of the second of the two
  Of of = Of::Increment;
};

/// False: the run ends here.
using StateVisitor = std::function<bool(const IntermediateState&)>;

/// Takes the run to its end and stops on the way in every increment and wherever cracks have grown. Where the run fails
/// it stops once more, and returns the failure.
[[nodiscard]] std::optional<assembly::Failure> visit_increments(growth::Evolution& body, const StateVisitor& visit);

/// Chooses `states` increments of a run, evenly over the load (fewer if the run has fewer), and all other stops.
class EvenlyOverLoad {
 public:
  explicit EvenlyOverLoad(int states) : states_(states) {}
  bool takes(const IntermediateState& state);

 private:
  double next() const { return (taken_ + 0.5) / states_; }
  int states_, taken_ = 0;  // loads (k + 1/2) / states that are behind
};

}  // namespace cleft::tangent_check
