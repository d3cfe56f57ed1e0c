#include "cleft/solve/linear_solver.hpp"

#include <cmath>
#include <limits>

#include "cleft/support/timer.hpp"
#include "mumps.hpp"
#include "umfpack.hpp"

namespace cleft::solve {
namespace {

// Condition number by inverse iteration: a body that may float has 2e13 and more, the block with 128 x 256 cells 7e4.
constexpr double kSingular = 1e12;

}  // namespace

struct LinearSolver::Data {
  SolverSeconds seconds;
  Mumps mumps;
  Umfpack umfpack{seconds};
  bool repeated = false;  // the last factors are those of UMFPACK
  Factors factors = Factors::None;
  long pattern = -1;

  explicit Data(Factorisation kind) : mumps(seconds, kind) {}

  void factorise(const assembly::BlockMatrix& matrix) {
    factors = mumps.factorise(matrix);
    repeated = factors != Factors::Regular;
    if (!repeated) return;
    ++seconds.second_opinions;
    factors = umfpack.factorise(matrix);
  }
};

SolverSeconds& SolverSeconds::operator+=(const SolverSeconds& other) {
  analyse += other.analyse;
  factorise += other.factorise;
  solve += other.solve;
  analyses += other.analyses;
  factorisations += other.factorisations;
  second_opinions += other.second_opinions;
  return *this;
}

LinearSolver::LinearSolver(Factorisation kind) : data_(std::make_unique<Data>(kind)) {}
LinearSolver::~LinearSolver() = default;
LinearSolver::LinearSolver(LinearSolver&&) noexcept = default;
LinearSolver& LinearSolver::operator=(LinearSolver&&) noexcept = default;

void LinearSolver::new_pattern(long number) {
  data_->pattern = number;
  data_->factors = Factors::None;
  data_->mumps.forget();
  data_->umfpack.forget();
}

Factors LinearSolver::factorise(const assembly::BlockMatrix& matrix) {
  auto& d = *data_;
  ++d.seconds.factorisations;
  d.factors = Factors::None;
  if (!Eigen::Map<const VecX>(matrix.values().data(), matrix.nonzeros()).allFinite()) return d.factors;
  d.factorise(matrix);
  if (d.factors == Factors::Doubtful && condition(matrix) < kSingular) d.factors = Factors::Regular;
  return d.factors;
}

// Largest entry times the growth of a vector that two solutions turn toward the motion that least resists.
double LinearSolver::condition(const assembly::BlockMatrix& matrix) {
  VecX probe(matrix.rows());
  for (Eigen::Index k = 0; k < probe.size(); ++k) probe[k] = std::sin(static_cast<double>(k * k));  // no pattern in it
  for (int k = 0; k < 2; ++k) {
    const VecX grown = solve(probe.normalized());
    if (!grown.allFinite()) return std::numeric_limits<double>::infinity();
    probe = grown;
  }
  return Eigen::Map<const VecX>(matrix.values().data(), matrix.nonzeros()).cwiseAbs().maxCoeff() * probe.norm();
}

VecX LinearSolver::solve(const VecX& b) {
  auto& d = *data_;
  const PhaseTimer timer(d.seconds.solve);
  return d.repeated ? d.umfpack.solve(b) : d.mumps.solve(b);
}

Pivots LinearSolver::pivots() const { return data_->repeated ? data_->umfpack.pivots() : data_->mumps.pivots(); }

bool LinearSolver::has_factors() const { return data_->factors == Factors::Regular; }

long LinearSolver::pattern() const { return data_->pattern; }

const SolverSeconds& LinearSolver::seconds() const { return data_->seconds; }

}  // namespace cleft::solve
