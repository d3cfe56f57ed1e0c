// Factorisation of symmetric positive definite matrices, by CHOLMOD.
#pragma once

#include <cholmod.h>

#include "cleft/assembly/linear_solver.hpp"

namespace cleft::assembly {

class Cholmod {
 public:
  explicit Cholmod(SolverSeconds& seconds);
  ~Cholmod();
  Cholmod(const Cholmod&) = delete;
  Cholmod& operator=(const Cholmod&) = delete;

  void forget();                                 ///< the next matrix has another pattern
  Factors factorise(const BlockMatrix& matrix);  ///< none if it is not positive definite
  VecX solve(const VecX& b);

 private:
  SolverSeconds& seconds_;
  cholmod_common common_;
  cholmod_factor* factor_ = nullptr;
};

}  // namespace cleft::assembly
