/// \file
/// Orders and limits of sequences of results over element sizes; powers by which costs grow.
#pragma once

#include <optional>
#include <span>
#include <string>

namespace cleft::convergence {

struct FitOptions {
  std::optional<double> limit;  ///< the exact value, if it is known: then only C and p are fitted
  /// With a limit: the results are distances from the one at this element size, smaller than theirs, and not from what
  /// the sequence tends to, so that C (h^p - reference_h^p) is fitted. Their errors are alike but for the factor.
  double reference_h = 0.0;
  double least_order = 0.1;  ///< bounds on p
  double most_order = 6.0;
};

/// The model Q(h) = Q0 + C h^p fitted to results. Uncertainties are half widths of 95 % confidence intervals: standard
/// deviation out of the covariance at the solution times the quantile of Student's t for the degrees of freedom, so
/// that few meshes give wide ones. They take what the model leaves for noise; NaN where there are as many parameters as
/// results.
struct LimitFit {
  double limit = 0.0;  ///< Q0; NaN where there are too few results
  double limit_pm = 0.0;
  double factor = 0.0;  ///< C
  double order = 0.0;   ///< p; NaN where there are too few results or all are equal
  double order_pm = 0.0;
  double scatter = 0.0;     ///< root mean square of what the model leaves, in the unit of Q
  bool determined = false;  ///< whether the data determine p (and with it a limit that is not given)
  std::string remark;       ///< why not, or what to know of the uncertainty
};

/// Fits by least squares with a robust loss (Huber's, at 1.5 times the scatter that it leaves; where there are at least
/// two results more than parameters). Known limits are fitted in relative error, so that every mesh has its say. `h`
/// and `value` have equal lengths. Throws std::invalid_argument on fewer than two results, on h that are not positive
/// or not distinct, or on values that are not finite.
LimitFit fit_limit(std::span<const double> h, std::span<const double> value, const FitOptions& options = {});

/// The model C x^p fitted to costs over sizes (seconds over unknowns), in relative error by the same means: a limit of
/// 0 that p may have any sign for. Costs of 0 are left out. Below three costs over three distinct sizes p is NaN and
/// the remark says so. Throws std::invalid_argument on unequal lengths, on x that are not positive, or on costs below 0
/// or not finite.
LimitFit fit_power(std::span<const double> x, std::span<const double> cost);

}  // namespace cleft::convergence
