#include "cleft/assembly/linear_solver.hpp"

#include <cholmod.h>
#include <umfpack.h>

#include <cmath>
#include <limits>
#include <new>

#include "cleft/support/timer.hpp"

namespace cleft::assembly {
namespace {

// Smallest over largest pivot. A body that may float leaves 1e-13 or less, whatever the mesh; springs 1e6 times as
// stiff as the elements 1e-11, Poisson's ratio 0.499999 4e-7, slivers of 1e-9 of an element nothing to speak of. But
// regular matrices may have such pivots, too: on the block with 128 x 256 cells 4e-13.
constexpr double kSuspicious = 1e-12;

// Condition number by inverse iteration: a body that may float has 2e13 and more, that block 7e4.
constexpr double kSingular = 1e12;

Factors graded(double pivot_ratio) { return pivot_ratio > kSuspicious ? Factors::Regular : Factors::Doubtful; }

}  // namespace

struct LinearSolver::Data {
  Factorisation kind;
  SolverSeconds seconds;
  void* symbolic = nullptr;
  void* numeric = nullptr;
  cholmod_common common;
  cholmod_factor* factor = nullptr;
  bool positive_definite = false;
  Factors factors = Factors::None;
  long pattern = -1;

  explicit Data(Factorisation k) : kind(k) {
    cholmod_start(&common);
    common.supernodal = CHOLMOD_SUPERNODAL;
    common.error_handler = nullptr;
    common.print = 0;
  }
  Data(const Data&) = delete;
  Data& operator=(const Data&) = delete;
  ~Data() {
    free_umfpack();
    cholmod_free_factor(&factor, &common);
    cholmod_finish(&common);
  }

  void free_umfpack() {
    if (numeric) umfpack_di_free_numeric(&numeric);
    if (symbolic) umfpack_di_free_symbolic(&symbolic);
  }

  // CHOLMOD reads the upper triangle only, so that the whole matrix can be handed over as it is.
  static cholmod_sparse view(const BlockMatrix& m) {
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

  Factors factorise_general(const BlockMatrix& m) {
    if (!symbolic) {
      const PhaseTimer timer(seconds.analyse);
      ++seconds.analyses;
      // without values: the order depends on the pattern alone, so that a resumed run repeats it exactly
      if (umfpack_di_symbolic(m.rows(), m.rows(), m.scalar_starts().data(), m.scalar_rows().data(), nullptr, &symbolic,
                              nullptr, nullptr) == UMFPACK_ERROR_out_of_memory)
        throw std::bad_alloc();
    }
    if (numeric) umfpack_di_free_numeric(&numeric);
    const PhaseTimer timer(seconds.factorise);
    std::array<double, UMFPACK_INFO> info{};
    const int status = umfpack_di_numeric(m.scalar_starts().data(), m.scalar_rows().data(), m.values().data(), symbolic,
                                          &numeric, nullptr, info.data());
    if (status == UMFPACK_ERROR_out_of_memory) throw std::bad_alloc();
    return status == UMFPACK_OK ? graded(info[UMFPACK_RCOND]) : Factors::None;
  }

  Factors factorise_symmetric(const BlockMatrix& m) {
    cholmod_sparse a = view(m);
    if (!factor) {
      const PhaseTimer timer(seconds.analyse);
      ++seconds.analyses;
      factor = cholmod_analyze(&a, &common);
    }
    const PhaseTimer timer(seconds.factorise);
    cholmod_factorize(&a, factor, &common);
    if (common.status == CHOLMOD_OUT_OF_MEMORY) throw std::bad_alloc();
    const bool positive = common.status == CHOLMOD_OK && factor->minor == factor->n;
    return positive ? graded(cholmod_rcond(factor, &common)) : Factors::None;
  }
};

SolverSeconds& SolverSeconds::operator+=(const SolverSeconds& other) {
  analyse += other.analyse;
  factorise += other.factorise;
  solve += other.solve;
  analyses += other.analyses;
  factorisations += other.factorisations;
  unsymmetric_fallbacks += other.unsymmetric_fallbacks;
  return *this;
}

LinearSolver::LinearSolver(Factorisation kind) : data_(std::make_unique<Data>(kind)) {}
LinearSolver::~LinearSolver() = default;
LinearSolver::LinearSolver(LinearSolver&&) noexcept = default;
LinearSolver& LinearSolver::operator=(LinearSolver&&) noexcept = default;

void LinearSolver::new_pattern(long number) {
  data_->pattern = number;
  data_->factors = Factors::None;
  data_->free_umfpack();
  cholmod_free_factor(&data_->factor, &data_->common);
}

Factors LinearSolver::factorise(const BlockMatrix& matrix) {
  auto& d = *data_;
  ++d.seconds.factorisations;
  d.positive_definite = false;
  d.factors = Factors::None;
  // CHOLMOD takes them for positive definite
  if (!Eigen::Map<const VecX>(matrix.values().data(), matrix.nonzeros()).allFinite()) return d.factors;
  if (d.kind == Factorisation::Symmetric) {
    d.factors = d.factorise_symmetric(matrix);
    d.positive_definite = d.factors != Factors::None;
    if (!d.positive_definite) ++d.seconds.unsymmetric_fallbacks;
  }
  if (!d.positive_definite) d.factors = d.factorise_general(matrix);
  if (d.factors == Factors::Doubtful && condition(matrix) < kSingular) d.factors = Factors::Regular;
  return d.factors;
}

// Largest entry times the growth of a vector that two solutions turn toward the motion that least resists.
double LinearSolver::condition(const BlockMatrix& matrix) {
  VecX probe(matrix.rows());
  for (Eigen::Index k = 0; k < probe.size(); ++k) probe[k] = std::sin(static_cast<double>(k * k));  // no pattern in it
  for (int k = 0; k < 2; ++k) {
    const VecX grown = solve(matrix, probe.normalized());
    if (!grown.allFinite()) return std::numeric_limits<double>::infinity();
    probe = grown;
  }
  return Eigen::Map<const VecX>(matrix.values().data(), matrix.nonzeros()).cwiseAbs().maxCoeff() * probe.norm();
}

VecX LinearSolver::solve(const BlockMatrix& matrix, const VecX& b) {
  auto& d = *data_;
  const PhaseTimer timer(d.seconds.solve);
  VecX x(matrix.rows());
  if (!d.positive_definite) {
    umfpack_di_solve(UMFPACK_A, matrix.scalar_starts().data(), matrix.scalar_rows().data(), matrix.values().data(),
                     x.data(), b.data(), d.numeric, nullptr, nullptr);
    return x;
  }
  cholmod_dense rhs{};
  rhs.nrow = rhs.nzmax = rhs.d = static_cast<std::size_t>(matrix.rows());
  rhs.ncol = 1;
  rhs.x = const_cast<double*>(b.data());
  rhs.xtype = CHOLMOD_REAL;
  rhs.dtype = CHOLMOD_DOUBLE;
  cholmod_dense* result = cholmod_solve(CHOLMOD_A, d.factor, &rhs, &d.common);
  x = Eigen::Map<const VecX>(static_cast<const double*>(result->x), x.size());
  cholmod_free_dense(&result, &d.common);
  return x;
}

bool LinearSolver::has_factors() const { return data_->factors == Factors::Regular; }

long LinearSolver::pattern() const { return data_->pattern; }

const SolverSeconds& LinearSolver::seconds() const { return data_->seconds; }

}  // namespace cleft::assembly
