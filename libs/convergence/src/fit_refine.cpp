#include "fit_refine.hpp"

#include <ceres/ceres.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace cleft::convergence {
namespace {

// Limit, factor, order, and the factors a and b of the terms that follow; limit and factor in units near 1.
constexpr int kParameters = 5;

// (y - Q0 - C (x^p (1 + a x + b x^2) - r^p (1 + a r + b r^2))) / deviation; deviations over the error where it is known
struct Misfit {
  double x, y, reference, deviation;
  bool has_limit;

  template <class T>
  static T shape(double x, const T* q) {
    using std::pow;
    return pow(T(x), q[2]) * (1.0 + q[3] * x + q[4] * x * x);
  }
  template <class T>
  bool operator()(const T* q, T* residual) const {
    T model = shape(x, q);
    if (reference > 0.0) model -= shape(reference, q);
    residual[0] = has_limit ? (y - q[0] - q[1] * model) / deviation : (q[1] * model / y - 1.0) / deviation;
    return true;
  }
};

// Pre-asymptotic terms are normal; a limit that is known stays where it is.
struct Prior {
  double deviation;
  template <class T>
  bool operator()(const T* q, T* residual) const {
    residual[0] = q[3] / deviation;
    residual[1] = q[4] / deviation;
    return true;
  }
};

}  // namespace

Draw most_probable(const Sequence& sequence, const Posterior& posterior) {
  Draw out = posterior.best;
  const double unit = std::fabs(out.factor), coarsest = sequence.h[0];
  const double origin = sequence.has_limit ? sequence.value.back() : 0.0;
  std::array<double, kParameters> q{(out.limit - origin) / unit, out.factor / unit, out.order, 0.0, 0.0};
  ceres::Problem problem;
  for (std::size_t k = 0; k < sequence.size(); ++k) {
    const double deviation = std::hypot(out.scatter, out.outlier > 0.0 && out.outlier_at == k ? out.outlier : 0.0);
    problem.AddResidualBlock(new ceres::AutoDiffCostFunction<Misfit, 1, kParameters>(
                                 new Misfit{sequence.h[k] / coarsest, (sequence.value[k] - origin) / unit,
                                            sequence.reference / coarsest, deviation, sequence.has_limit}),
                             nullptr, q.data());
  }
  problem.AddResidualBlock(new ceres::AutoDiffCostFunction<Prior, 2, kParameters>(new Prior{out.pre_asymptotic}),
                           nullptr, q.data());
  if (!sequence.has_limit) problem.SetManifold(q.data(), new ceres::SubsetManifold(kParameters, {0}));
  problem.SetParameterLowerBound(q.data(), 2, kLeastOrder);
  problem.SetParameterUpperBound(q.data(), 2, kMostOrder);
  ceres::Solver::Options controls;
  controls.linear_solver_type = ceres::DENSE_QR;
  controls.logging_type = ceres::SILENT;
  controls.max_num_iterations = 200;
  controls.function_tolerance = controls.gradient_tolerance = controls.parameter_tolerance = 1e-14;
  ceres::Solver::Summary summary;
  ceres::Solve(controls, &problem, &summary);
  out.limit = origin + unit * q[0];
  out.factor = unit * q[1];
  out.order = q[2];
  return out;
}

}  // namespace cleft::convergence
