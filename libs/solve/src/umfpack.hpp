// Factorisation of any matrix, by UMFPACK: slower than MUMPS, but it tells the size of every pivot.
#pragma once

#include "cleft/solve/linear_solver.hpp"

namespace cleft::solve {

class Umfpack {
 public:
  explicit Umfpack(SolverSeconds& seconds) : seconds_(seconds) {}
  ~Umfpack() { forget(); }
  Umfpack(const Umfpack&) = delete;
  Umfpack& operator=(const Umfpack&) = delete;

  void forget();  ///< the next matrix has another pattern
  Factors factorise(const assembly::BlockMatrix& matrix);
  VecX solve(const VecX& b) const;
  Pivots pivots() const;  ///< of the last factorisation

 private:
  SolverSeconds& seconds_;
  void* symbolic_ = nullptr;
  void* numeric_ = nullptr;
  double least_pivot_ = 0.0;
};

}  // namespace cleft::solve
