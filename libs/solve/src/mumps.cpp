#include "mumps.hpp"

#include <limits>
#include <mutex>
#include <new>

#include "cleft/support/timer.hpp"
#include "factors.hpp"
#include "nested_dissection.hpp"

namespace cleft::solve {
namespace {

constexpr int kStart = -1, kEnd = -2, kAnalyse = 1, kFactorise = 2, kSolve = 3;
constexpr int kGeneralSymmetric = 2;
constexpr int kUseWorldCommunicator = -987654;

// The manual counts from 1.
MUMPS_INT& control(DMUMPS_STRUC_C& data, int number) { return data.icntl[number - 1]; }
MUMPS_INT outcome(const DMUMPS_STRUC_C& data, int number) { return data.infog[number - 1]; }

bool out_of_memory(int error) { return error == -7 || error == -13; }
bool lacked_workspace(int error) { return error == -8 || error == -9; }

// The outcome of a job, but for lack of memory.
int checked(int outcome) {
  if (out_of_memory(outcome)) throw std::bad_alloc();
  return outcome;
}

}  // namespace

int Mumps::call(int job) noexcept {
  static std::mutex one_at_a_time;
  const std::lock_guard lock(one_at_a_time);
  data_->job = job;
  dmumps_c(data_.get());
  return outcome(*data_, 1);
}

void Mumps::forget() {
  if (!data_) return;
  call(kEnd);
  data_.reset();
}

void Mumps::analyse(const assembly::BlockMatrix& m) {
  const PhaseTimer timer(seconds_.analyse);
  ++seconds_.analyses;
  data_ = std::make_unique<DMUMPS_STRUC_C>();
  auto& d = *data_;
  d.comm_fortran = kUseWorldCommunicator;
  d.par = 1;
  d.sym = symmetric_ ? kGeneralSymmetric : 0;
  checked(call(kStart));
  for (const int stream : {1, 2, 3, 4}) control(d, stream) = 0;  // prints nothing
  control(d, 6) = 0;                                             // no permutation of columns: the pattern is symmetric
  control(d, 8) = 0;                                             // no scaling: the matrix comes scaled
  control(d, 10) = 0;                                            // no refinement
  control(d, 14) = 30;                                           // per cent of workspace beyond the estimate
  control(d, 24) = 1;                                            // finds tiny pivots
  control(d, 28) = 1;                                            // analysis in one process
  control(d, 33) = 1;                                            // tells the determinant

  rows_.clear();
  columns_.clear();
  for (Index j = 0; j < m.rows(); ++j)
    for (Index k = m.scalar_starts()[j]; k < m.scalar_starts()[j + 1]; ++k)
      if (const Index i = m.scalar_rows()[k]; i <= j || !symmetric_) {
        rows_.push_back(i + 1);
        columns_.push_back(j + 1);
      }
  d.n = m.rows();
  d.nnz = static_cast<MUMPS_INT8>(rows_.size());
  d.irn = rows_.data();
  d.jcn = columns_.data();
  std::vector<Index> order;
  const bool dissected = m.rows() >= dissected_from_;
  control(d, 7) = dissected ? 1 : 0;
  if (dissected) {
    order = nested_dissection(m);
    for (Index& position : order) ++position;
    d.perm_in = order.data();
  }
  const int analysed = call(kAnalyse);
  d.perm_in = nullptr;
  checked(analysed);
}

// The values in the order of `rows_`.
double* Mumps::entries(const assembly::BlockMatrix& m) {
  if (!symmetric_) return const_cast<double*>(m.values().data());
  upper_.clear();
  upper_.reserve(rows_.size());
  for (Index j = 0; j < m.rows(); ++j)
    for (Index k = m.scalar_starts()[j]; k < m.scalar_starts()[j + 1] && m.scalar_rows()[k] <= j; ++k)
      upper_.push_back(m.values()[k]);
  return upper_.data();
}

Factors Mumps::factorise(const assembly::BlockMatrix& m) {
  if (!data_) analyse(m);
  const PhaseTimer timer(seconds_.factorise);
  auto& d = *data_;
  d.a = entries(m);
  const double largest = Eigen::Map<const VecX>(m.values().data(), m.nonzeros()).cwiseAbs().maxCoeff();
  d.cntl[2] = -kSuspiciousPivot * largest;
  int error = checked(call(kFactorise));
  for (int doubled = 0; lacked_workspace(error) && doubled < 6; ++doubled) {
    control(d, 14) *= 2;
    error = checked(call(kFactorise));
  }
  constexpr int kTinyPivots = 28;
  return error == 0 && outcome(d, kTinyPivots) == 0 ? Factors::Regular : Factors::Doubtful;
}

Pivots Mumps::pivots() const {
  constexpr int kDeterminant = 12, kLeast = 20, kLargest = 21;
  const auto info = [this](int number) { return data_->rinfog[number - 1]; };
  return {info(kDeterminant) < 0.0, info(kLeast) / info(kLargest)};
}

VecX Mumps::solve(const VecX& b) {
  VecX x = b;
  data_->rhs = x.data();
  if (checked(call(kSolve)) < 0) x.setConstant(std::numeric_limits<double>::quiet_NaN());
  data_->rhs = nullptr;
  return x;
}

}  // namespace cleft::solve
