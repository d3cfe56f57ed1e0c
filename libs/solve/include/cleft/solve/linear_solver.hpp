/// \file
/// Direct solution of the sparse systems.
#pragma once

#include <memory>

#include "cleft/assembly/block_matrix.hpp"

namespace cleft::solve {

enum class Factorisation { Unsymmetric, Symmetric };

/// Seconds spent in each phase of all calls so far, and their numbers.
struct SolverSeconds {
  double analyse = 0.0, factorise = 0.0, solve = 0.0;
  long analyses = 0, factorisations = 0;
  long second_opinions = 0;  ///< factorisations that UMFPACK made again, since MUMPS met a tiny pivot
  SolverSeconds& operator+=(const SolverSeconds& other);
};

/// What a factorisation found: a matrix that is not finite or exactly singular has no factors; one that is singular but
/// for rounding has doubtful ones.
enum class Factors { None, Doubtful, Regular };

/// What a factorisation tells of the stability of the body.
struct Pivots {
  bool negative_determinant = false;
  double least = 1.0;  ///< smallest pivot over the largest, without sign
};

/// MUMPS, by L U or, of symmetric matrices, which may be indefinite, by L D L^T. Where it meets tiny pivots UMFPACK
/// decides.
class LinearSolver {
 public:
  explicit LinearSolver(Factorisation kind);
  ~LinearSolver();
  LinearSolver(LinearSolver&&) noexcept;
  LinearSolver& operator=(LinearSolver&&) noexcept;

  /// Says that matrices have another pattern from now on, under a number of the caller's; it is analysed at the next
  /// factorisation and the analysis kept until the next call.
  void new_pattern(long number);
  long pattern() const;

  /// Whether there are regular factors of a matrix with that pattern.
  bool has_factors() const;

  /// Factorises the values. Throws std::bad_alloc where the factors do not fit into the memory.
  [[nodiscard]] Factors factorise(const assembly::BlockMatrix& matrix);

  /// Solves A x = b with the last factorisation; with a doubtful one the solution is the motion that nothing resists.
  VecX solve(const VecX& b);

  /// Of the last factorisation, which has left factors.
  Pivots pivots() const;

  const SolverSeconds& seconds() const;

 private:
  double condition(const assembly::BlockMatrix& matrix);

  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace cleft::solve
