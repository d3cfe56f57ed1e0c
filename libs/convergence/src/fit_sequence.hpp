// A sequence of results over element sizes, described without a fit.
#pragma once

#include <span>
#include <vector>

#include "cleft/convergence/fit.hpp"

namespace cleft::convergence {

/// Coarsest first. With a known limit `value` are distances from it, without those that are 0, and `reference` is the
/// size at which they vanish.
struct Sequence {
  std::vector<double> h, value;
  bool has_limit = true;  ///< the sequence tends to what is not known
  double reference = 0.0;
  double rounding = 0.0;  ///< differences below it are none

  std::size_t size() const { return h.size(); }
  Sequence finest(std::size_t count) const;
};

/// Sorts by h. Throws std::invalid_argument as fit_limit does.
Sequence sequence_of(std::span<const double> h, std::span<const double> value, const FitOptions& options);

/// What gets smaller as the order tells: differences of successive values, with a known limit the values.
std::vector<double> steps_of(const Sequence& s);

/// What the step after number k (of steps_of) is over step k in a sequence of pure order p.
double ratio_of_steps(const Sequence& s, std::size_t k, double p);

SeriesClass class_of(const Sequence& s);

/// As LimitFit::observed_order.
std::vector<double> observed_orders(const Sequence& s);

}  // namespace cleft::convergence
