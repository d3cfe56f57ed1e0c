#include "cholmod.hpp"

#include <new>

#include "cleft/support/timer.hpp"
#include "factors.hpp"

namespace cleft::assembly {
namespace {

// CHOLMOD reads the upper triangle only, so that the whole matrix can be handed over as it is.
cholmod_sparse upper_of(const BlockMatrix& m) {
  cholmod_sparse a{};
  a.nrow = a.ncol = static_cast<std::size_t>(m.rows());
  a.nzmax = static_cast<std::size_t>(m.nonzeros());
  a.p = const_cast<Index*>(m.scalar_starts().data());
  a.i = const_cast<Index*>(m.scalar_rows().data());
  a.x = const_cast<double*>(m.values().data());
  a.stype = 1;
  a.itype = CHOLMOD_INT;
  a.xtype = CHOLMOD_REAL;
  a.dtype = CHOLMOD_DOUBLE;
  a.sorted = a.packed = 1;
  return a;
}

}  // namespace

Cholmod::Cholmod(SolverSeconds& seconds) : seconds_(seconds) {
  cholmod_start(&common_);
  common_.supernodal = CHOLMOD_SUPERNODAL;
  common_.error_handler = nullptr;
  common_.print = 0;
}

Cholmod::~Cholmod() {
  forget();
  cholmod_finish(&common_);
}

void Cholmod::forget() { cholmod_free_factor(&factor_, &common_); }

Factors Cholmod::factorise(const BlockMatrix& m) {
  cholmod_sparse a = upper_of(m);
  if (!factor_) {
    const PhaseTimer timer(seconds_.analyse);
    ++seconds_.analyses;
    factor_ = cholmod_analyze(&a, &common_);
  }
  const PhaseTimer timer(seconds_.factorise);
  cholmod_factorize(&a, factor_, &common_);
  if (common_.status == CHOLMOD_OUT_OF_MEMORY) throw std::bad_alloc();
  const bool positive = common_.status == CHOLMOD_OK && factor_->minor == factor_->n;
  return positive ? graded(cholmod_rcond(factor_, &common_)) : Factors::None;
}

VecX Cholmod::solve(const VecX& b) {
  cholmod_dense rhs{};
  rhs.nrow = rhs.nzmax = rhs.d = static_cast<std::size_t>(b.size());
  rhs.ncol = 1;
  rhs.x = const_cast<double*>(b.data());
  rhs.xtype = CHOLMOD_REAL;
  rhs.dtype = CHOLMOD_DOUBLE;
  cholmod_dense* result = cholmod_solve(CHOLMOD_A, factor_, &rhs, &common_);
  const VecX x = Eigen::Map<const VecX>(static_cast<const double*>(result->x), b.size());
  cholmod_free_dense(&result, &common_);
  return x;
}

}  // namespace cleft::assembly
