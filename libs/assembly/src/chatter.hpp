// Iterations that go round in circles.
#pragma once

#include <limits>

#include "cleft/assembly/newton.hpp"

namespace cleft::assembly {

/// Contact may chatter: from the state of one iterate the linearised problem leads to that of another, and so on back
/// to the first, however small the increment. Half a correction leaves the circle.
class Chatter {
 public:
  /// Takes an iterate and says whether its correction is to be halved: late, while the residual has not fallen below
  /// half of the least so far and points still change.
  bool halves(int iteration, const Iteration& it);
  int halved() const { return halved_; }

 private:
  double least_ = std::numeric_limits<double>::infinity();
  int halved_ = 0;
};

}  // namespace cleft::assembly
