// Iterations that go round in circles: the contact state repeats every second time.
#pragma once

#include <vector>

#include "cleft/support/types.hpp"

namespace cleft::assembly {

/// Watches the states of an increment's iterates.
class Chatter {
 public:
  /// Takes an iterate: what every contact point and hat is doing, as numbers, and the residual. True where the state is
  /// that of the last but one iterate and not that of the last, and the residual has not fallen to a tenth meanwhile: a
  /// full correction would lead to the other state again. Each such answer starts the count anew.
  bool repeats(std::vector<Index> state, double residual);

 private:
  struct Seen {
    std::vector<Index> state;
    double residual;
  };
  std::vector<Seen> seen_;
};

}  // namespace cleft::assembly
