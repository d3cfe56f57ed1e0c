/// \file
/// Orders and limits of sequences of results over element sizes, and what is uncertain about the finest result; powers
/// by which costs grow.
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace cleft::convergence {

struct FitOptions {
  std::optional<double>
      limit;  ///< the exact value, if it is known: then the results have errors, and only p is asked for
  /// With a limit: the results are distances from the one at this element size, smaller than theirs, and not from what
  /// the sequence tends to, so that C (h^p - reference_h^p) is fitted. Their errors are alike but for the factor.
  double reference_h = 0.0;
};

inline constexpr double kNotKnown = std::numeric_limits<double>::quiet_NaN();

/// How a sequence behaves on its finest four meshes, by the differences of successive ones (with a known limit: by the
/// errors). Those below the rounding of the results count as 0.
enum class SeriesClass {
  TooFew,       ///< too few meshes to tell
  Exact,        ///< equal but for rounding
  Monotone,     ///< differences of one sign that get smaller
  Oscillating,  ///< differences change their sign
  Diverging     ///< differences of one sign that do not get smaller: the last observed order is 0 or less
};
const char* name_of(SeriesClass kind);  ///< "too few meshes", "exact to rounding", "monotone", ...

/// The answer to a sequence of results. Half widths (`_pm`) are of 95 % intervals that count pre-asymptotic terms,
/// scatter and one outlier; kNotKnown stands where nothing can be said.
struct LimitFit {
  SeriesClass kind = SeriesClass::TooFew;
  /// Observed order of each three successive meshes, coarsest first: of C h^p through their results (with a known limit
  /// of each two meshes). NaN where the differences change sign or vanish; 0 or less where they grow.
  std::vector<double> observed_order;
  /// The last difference over what the order makes of the one before: near 1 in the asymptotic range.
  double asymptotic_ratio = kNotKnown;
  std::size_t window = 0;  ///< how many of the finest meshes the answer is of

  double limit = kNotKnown;  ///< Q0; to be shown only where it is given or `determined`
  double limit_pm = kNotKnown;
  double factor = kNotKnown;  ///< C
  double order = kNotKnown;   ///< p
  double order_pm = kNotKnown;
  double scatter = kNotKnown;  ///< root mean square of what C h^p leaves in the window, in the unit of Q

  /// Uncertainty of the finest result, in the unit of Q: the exact value lies within finest_pm of it in 95 of 100
  /// cases. It is a grid convergence index (ASME V&V 20): `safety` times the error, of which the largest is taken that
  /// the data allow with 95 %. NaN with a known limit, of which the error is known.
  double finest_pm = kNotKnown;
  double safety = kNotKnown;  ///< 1.25 where determined, 2 where not, 3 of three meshes

  bool determined = false;  ///< whether the data determine p and (if it is not given) the limit
  std::string remark;       ///< why not
};

/// Fits Q0 + C h^p (1 + a h + b h^2) to windows of the finest meshes, four or more (the finest twelve at most), with
/// random pre-asymptotic terms a and b and random scatter, and chooses the largest window whose answer the smaller ones
/// do not contradict. Scatter is of one size on all meshes; with a known limit it is relative to the error.
///
/// `h` and `value` have equal lengths, any order. Throws std::invalid_argument on fewer than two results, on h that are
/// not positive or not distinct, or on values that are not finite or whose differences are not.
///
/// Sources: Oates, Karvonen, Teckentrup, Strocchi and Niederer, J. R. Stat. Soc. B 87 (2025) 457 (probabilistic
/// Richardson extrapolation); ASME V&V 20-2009 (factors of safety). How often the intervals hold: the page "How sure is
/// a fit?" of the documentation.
LimitFit fit_limit(std::span<const double> h, std::span<const double> value, const FitOptions& options = {});

/// The model C x^p. The half width is the larger of 95 % by Student's t and of what any one cost does to p.
struct PowerFit {
  double factor = kNotKnown;  ///< C
  double order = kNotKnown;   ///< p, of any sign
  double order_pm = kNotKnown;
  bool determined = false;  ///< by four sizes or more, where p is known to 0.25
  std::string remark;       ///< why not
};

/// Fits C x^p to costs over sizes (seconds over unknowns), in relative error. Costs of 0 are left out. Below three
/// costs over three distinct sizes p is NaN and the remark says so. Throws std::invalid_argument on unequal lengths, on
/// x that are not positive, or on costs below 0 or not finite.
PowerFit fit_power(std::span<const double> x, std::span<const double> cost);

}  // namespace cleft::convergence
