// What a sequence of results tells of its limit and order: Richardson's extrapolation with probabilities, after
// Oates, Karvonen, Teckentrup, Strocchi and Niederer, Probabilistic Richardson extrapolation, arXiv:2401.07562 (2024).
// The sequence is taken for one draw of
//
//     Q_i = Q0 + C (x_i^p (1 + a x_i + b x_i^2) + t z_i),   x_i = h_i / h_max,
//
// a and b normal of deviation A, z standard normal, and at most one z so large that it counts as an outlier. Nothing is
// assumed of Q0 and C (densities 1 and 1/|C|, which make the answer turn with unit and origin). p, A and t have the
// prior densities of the source file. Q0, a, b and z are integrated exactly, C, p, A, t and the outlier by sums.
//
// So pre-asymptotic terms count as such: coarse meshes have the less weight the larger a and b can be, fine ones the
// less the larger the scatter is.
#pragma once

#include <cstddef>

#include "fit_sequence.hpp"

namespace cleft::convergence {

inline constexpr double kLeastOrder = 0.35, kMostOrder = 5.0;  ///< of p
inline constexpr std::size_t kMostMeshes = 12;

/// What contains 95 % of a posterior: from 2.5 to 97.5 %.
struct Interval {
  double low = 0.0, high = 0.0;
};

/// One sequence of the family, and what is assumed of it: deviations over C, of an outlier at one mesh where
/// outlier > 0.
struct Draw {
  double limit = 0.0, factor = 0.0, order = 0.0;  ///< Q0; C over x, not h; p
  double pre_asymptotic = 0.0, scatter = 0.0;     ///< A, t
  double outlier = 0.0;
  std::size_t outlier_at = 0;
};

struct Posterior {
  Interval limit;             ///< Q0, in the unit of Q
  Interval order;             ///< p
  double finest_error = 0.0;  ///< 95 % of the limits are nearer than this to the finest result
  double scattered = 0.0;     ///< probability that the scatter t is 1 % or more
  Draw best;                  ///< among the points of the sums; its limit is the mean
};

/// A sequence with a limit that is not known has three meshes at least, others two; none more than kMostMeshes, and not
/// all results equal. With a known limit (0, so that the results are errors) only `order`, `scattered` and `best` are
/// filled in: the scatter z_i then is relative to the error.
Posterior posterior_of(const Sequence& sequence);

}  // namespace cleft::convergence
