/// \file
/// Orders and limits of sequences of results over element sizes.
#pragma once

#include <optional>
#include <span>
#include <string>

namespace cleft::verify {

struct FitOptions {
  std::optional<double> limit;  ///< the exact value, if it is known: then only C and p are fitted
  double least_order = 0.1;     ///< bounds on p
  double most_order = 6.0;
};

/// The model Q(h) = Q0 + C h^p fitted to results.
struct LimitFit {
  double limit = 0.0;        ///< Q0
  double limit_sigma = 0.0;  ///< standard deviation; 0 if the limit was given
  double factor = 0.0;       ///< C
  double order = 0.0;        ///< p
  double order_sigma = 0.0;  ///< standard deviation
  double scatter = 0.0;      ///< root mean square of what the model leaves, in the unit of Q
  bool determined = false;   ///< whether the data determine p
  std::string remark;        ///< why not
};

/// Fits by least squares with a robust loss. `h` and `value` have equal lengths. Throws std::invalid_argument on fewer
/// than two points, on h that are not positive or not distinct, or on values that are not finite.
LimitFit fit_limit(std::span<const double> h, std::span<const double> value, const FitOptions& options = {});

}  // namespace cleft::verify
