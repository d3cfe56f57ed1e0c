// Iterations that go round in circles: the contact comes back to a state that it had left.
#pragma once

#include <vector>

#include "cleft/support/types.hpp"

namespace cleft::assembly {

/// Watches the states of an increment's iterates.
class Chatter {
 public:
  /// Takes an iterate: what every contact point and hat is doing, as numbers, and the residual. True where an earlier
  /// iterate, with others in between, was in the same state and the residual has not halved since: a full correction
  /// would lead round the same circle. Each such answer starts the watch anew.
  bool repeats(std::vector<Index> state, double residual);

 private:
  struct Seen {
    std::vector<Index> state;
    double residual;
  };
  std::vector<Seen> seen_;
};

}  // namespace cleft::assembly
