// Factorisation of any matrix, by UMFPACK: slower than MUMPS, but it tells the size of every pivot.
#pragma once

#include "cleft/assembly/linear_solver.hpp"

namespace cleft::assembly {

class Umfpack {
 public:
  explicit Umfpack(SolverSeconds& seconds) : seconds_(seconds) {}
  ~Umfpack() { forget(); }
  Umfpack(const Umfpack&) = delete;
  Umfpack& operator=(const Umfpack&) = delete;

  void forget();  ///< the next matrix has another pattern
  Factors factorise(const BlockMatrix& matrix);
  VecX solve(const VecX& b) const;

 private:
  SolverSeconds& seconds_;
  void* symbolic_ = nullptr;
  void* numeric_ = nullptr;
};

}  // namespace cleft::assembly
