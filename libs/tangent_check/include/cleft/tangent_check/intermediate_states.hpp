/// \file
/// States between the converged ones of a run.
#pragma once

#include <functional>

#include "cleft/growth/evolution.hpp"

namespace cleft::tangent_check {

/// Part of the way from one converged state to the next, with the history of the first: contact points that slide do so
/// in earnest, and none that sticks has just reached its limit.
struct IntermediateState {
  const assembly::Model& model;
  const assembly::State& before;  ///< the first of the two converged states
  VecX displacement;              ///< metres, all components
  double load = 0.0;
};

/// Takes the run to its end and stops on the way in `states` increments, evenly over the load (in fewer if the run has
/// fewer), and wherever cracks have grown, on the way from the state that they were cut through. Ends early where
/// `visit` returns false. Where the run fails it stops once more, part of the way along the first correction of an
/// increment from what converged last, and returns the failure.
[[nodiscard]] std::optional<assembly::Failure> visit_intermediate_states(
    growth::Evolution& body, int states, const std::function<bool(const IntermediateState&)>& visit);

}  // namespace cleft::tangent_check
