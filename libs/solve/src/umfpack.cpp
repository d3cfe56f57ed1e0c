#include "umfpack.hpp"

#include <umfpack.h>

#include <array>
#include <limits>
#include <new>

#include "cleft/support/timer.hpp"
#include "factors.hpp"

namespace cleft::solve {

void Umfpack::forget() {
  if (numeric_) umfpack_di_free_numeric(&numeric_);
  if (symbolic_) umfpack_di_free_symbolic(&symbolic_);
}

Factors Umfpack::factorise(const assembly::BlockMatrix& m) {
  std::array<double, UMFPACK_CONTROL> control{};
  umfpack_di_defaults(control.data());
  control[UMFPACK_STRATEGY] = UMFPACK_STRATEGY_SYMMETRIC;  // which the pattern is
  if (!symbolic_) {
    const PhaseTimer timer(seconds_.analyse);
    ++seconds_.analyses;
    // without values: the order depends on the pattern alone, so that a resumed run repeats it exactly
    if (umfpack_di_symbolic(m.rows(), m.rows(), m.scalar_starts().data(), m.scalar_rows().data(), nullptr, &symbolic_,
                            control.data(), nullptr) == UMFPACK_ERROR_out_of_memory)
      throw std::bad_alloc();
  }
  if (numeric_) umfpack_di_free_numeric(&numeric_);
  const PhaseTimer timer(seconds_.factorise);
  std::array<double, UMFPACK_INFO> info{};
  const int status = umfpack_di_numeric(m.scalar_starts().data(), m.scalar_rows().data(), m.values().data(), symbolic_,
                                        &numeric_, control.data(), info.data());
  if (status == UMFPACK_ERROR_out_of_memory) throw std::bad_alloc();
  if (status != UMFPACK_OK) return Factors::None;
  least_pivot_ = info[UMFPACK_RCOND];
  return least_pivot_ > kSuspiciousPivot ? Factors::Regular : Factors::Doubtful;
}

Pivots Umfpack::pivots() const {
  double mantissa = 0.0, exponent = 0.0;
  umfpack_di_get_determinant(&mantissa, &exponent, numeric_, nullptr);
  return {mantissa < 0.0, least_pivot_};
}

VecX Umfpack::solve(const VecX& b) const {
  std::array<double, UMFPACK_CONTROL> control{};
  umfpack_di_defaults(control.data());
  control[UMFPACK_IRSTEP] = 0;  // no refinement, for which it would need the matrix once more
  VecX x(b.size());
  if (umfpack_di_solve(UMFPACK_A, nullptr, nullptr, nullptr, x.data(), b.data(), numeric_, control.data(), nullptr) < 0)
    x.setConstant(std::numeric_limits<double>::quiet_NaN());
  return x;
}

}  // namespace cleft::solve
