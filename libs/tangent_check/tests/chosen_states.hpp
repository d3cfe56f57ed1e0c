// A run with stops at some of its increments.
#pragma once

#include <gtest/gtest.h>

#include "cleft/tangent_check/intermediate_states.hpp"

namespace cleft::tangent_check {

/// Takes a sound run to its end and calls `see` at `states` states, evenly over the load.
template <class See>
void see_chosen_states(growth::Evolution& body, int states, const See& see) {
  EvenlyOverLoad chosen(states);
  EXPECT_FALSE(visit_increments(body, [&](const IntermediateState& state) {
    if (chosen.takes(state)) see(state);
    return true;
  }));
}

}  // namespace cleft::tangent_check
