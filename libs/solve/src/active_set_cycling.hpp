// Iterations whose contact does not settle.
#pragma once

#include <limits>

#include "cleft/solve/newton.hpp"

namespace cleft::solve {

/// The active set may cycle: from the state of one iterate the linearised problem leads to that of another, and so on
/// back to the first, however small the increment. Half a correction leaves the circle. Contact may also open or close
/// like a zip, a point in each iteration: that is slow, but every state is a new one and the residual falls. Such an
/// iteration is let go on with whole corrections.
class ActiveSetCycling {
 public:
  explicit ActiveSetCycling(int max_iterations) : max_iterations_(max_iterations) {}

  /// Takes an iterate, and whether an earlier one had its active set.
  void look_at(int iteration, const Iteration& it, bool again);
  /// Whether its correction is to be halved: late, while the residual has not fallen below half of the least so far,
  /// and points go round in circles or change without progress.
  bool halves();
  /// Whether the contact is late and does not settle by itself: it goes round in circles or the residual hardly falls
  /// twice in a row.
  bool struggles() const { return is_late() && (circles_ || slow_in_a_row_ > 1); }
  /// Whether there are no further corrections: unless contact still changes and the residual falls, all are made.
  bool is_over() const;
  /// Whether an iteration that goes well would have found its contact.
  bool is_late() const;
  int halved() const { return halved_; }

 private:
  int max_iterations_;
  int iteration_ = 0;
  bool circles_ = false, slow_ = false, changes_ = false;        // at the last iterate
  int since_late_change_ = std::numeric_limits<int>::max() / 2;  // iterations
  double least_ = std::numeric_limits<double>::infinity();
  int since_least_ = 0, slow_in_a_row_ = 0;  // iterations
  int halved_ = 0;
};

}  // namespace cleft::solve
