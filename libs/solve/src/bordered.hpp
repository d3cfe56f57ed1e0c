// The linear system of an iteration, along a path with the load as one more unknown.
#pragma once

#include "cleft/solve/linear_solver.hpp"

namespace cleft::solve {

/// A correction of the displacements, and of the load that comes with it.
struct Correction {
  VecX displacement;
  double load = 0.0;
  Correction& operator+=(const Correction& other) {
    displacement += other.displacement;
    load += other.load;
    return *this;
  }
};

/// Solves with the factors of a matrix K,
///
///     K x = b,     or, along a path,     K x - q z = b,   w . x = c,
///
/// where q is what the right-hand side gains with the load, z the change of the load and w the path's progress.
class Bordered {
 public:
  /// `solver` must outlive this.
  explicit Bordered(LinearSolver& solver) : solver_(solver) {}

  /// From now on along a path: keeps a pointer to w, and solves for K^-1 q.
  void follow(const VecX& progress, const VecX& by_load);

  /// x and z for b, with c = 0.
  Correction solve(const VecX& b) const;
  /// x and z for c, with b = 0; only along a path.
  Correction go_on(double c) const;

 private:
  LinearSolver& solver_;
  const VecX* progress_ = nullptr;
  VecX along_;                      // K^-1 q
  double progress_of_along_ = 0.0;  // w . K^-1 q
};

}  // namespace cleft::solve
