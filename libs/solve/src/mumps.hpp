// Factorisation of any matrix or of a symmetric one, by MUMPS: the fastest, but it only says that a pivot is tiny, not
// how tiny.
#pragma once

#include <dmumps_c.h>

#include <memory>
#include <vector>

#include "cleft/solve/linear_solver.hpp"

namespace cleft::solve {

/// MUMPS keeps data of its own between calls, so that calls from several threads wait for each other.
class Mumps {
 public:
  /// From so many rows on, nested dissection leaves the faster factors; below, minimum degree costs less itself.
  static constexpr Index kDissected = 100'000;

  explicit Mumps(SolverSeconds& seconds, Factorisation kind, Index dissected_from = kDissected)
      : seconds_(seconds), symmetric_(kind == Factorisation::Symmetric), dissected_from_(dissected_from) {}
  ~Mumps() { forget(); }
  Mumps(const Mumps&) = delete;
  Mumps& operator=(const Mumps&) = delete;

  void forget();                                           ///< the next matrix has another pattern
  Factors factorise(const assembly::BlockMatrix& matrix);  ///< doubtful with a tiny pivot: such factors do not solve
  VecX solve(const VecX& b);
  Pivots pivots() const;  ///< of the last factorisation

 private:
  int call(int job) noexcept;
  void analyse(const assembly::BlockMatrix& matrix);
  double* entries(const assembly::BlockMatrix& matrix);

  SolverSeconds& seconds_;
  bool symmetric_;
  Index dissected_from_;
  std::unique_ptr<DMUMPS_STRUC_C> data_;
  std::vector<MUMPS_INT> rows_, columns_;  // from 1
  std::vector<double> upper_;              // of a symmetric matrix
};

}  // namespace cleft::solve
