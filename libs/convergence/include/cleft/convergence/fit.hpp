/// \file
/// Orders and limits of sequences of results over element sizes, and what is uncertain about the finest result; powers
/// by which costs grow.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace cleft::convergence {

struct FitOptions {
  std::optional<double> limit;  ///< the exact value, if it is known: then only C and p are fitted
  /// With a limit: the results are distances from the one at this element size, smaller than theirs, and not from what
  /// the sequence tends to, so that C (h^p - reference_h^p) is fitted. Their errors are alike but for the factor.
  double reference_h = 0.0;
};

/// How a sequence behaves, by the differences of successive meshes. Those below the rounding of the results count as 0.
enum class SeriesClass {
  TooFew,       ///< two meshes: one difference shows nothing
  Exact,        ///< equal but for rounding, on the finest three meshes at least
  Monotone,     ///< differences of one sign that get smaller
  Oscillating,  ///< differences change their sign
  Diverging     ///< differences of one sign that do not get smaller: the observed order is 0 or less
};
const char* name_of(SeriesClass kind);  ///< "too few meshes", "exact to rounding", "monotone", ...

/// What is fitted to the finest meshes of a sequence.
enum class FitModel {
  None,        ///< nothing: too few meshes, or exact results
  Power,       ///< Q0 + C h^p
  TwoTerms,    ///< Q0 + C h^p + D h^(p+1)
  First,       ///< Q0 + C h, where no p is plausible, as the next two
  Second,      ///< Q0 + C h^2
  FirstSecond  ///< Q0 + C h + D h^2
};
const char* name_of(FitModel model);  ///< "C h^p", "C h^p + D h^(p+1)", ...

/// The answer to a sequence of results. Half widths (`_pm`) are of 95 % intervals: the larger of what the scatter says
/// (Student's t) and of how far the answers of other windows, of the other model and without one mesh are. NaN stands
/// where nothing can be said.
struct LimitFit {
  SeriesClass kind = SeriesClass::TooFew;
  /// Observed order of each three successive meshes, coarsest first: of C h^p through their results (with a known limit
  /// of each two meshes). NaN where the differences change sign or vanish; 0 or less where they grow.
  std::vector<double> observed_order;
  /// The last difference over what the model's order makes of the one before: near 1 in the asymptotic range.
  double asymptotic_ratio = 0.0;
  FitModel model = FitModel::None;
  std::size_t window = 0;  ///< how many of the finest meshes are fitted

  double limit = 0.0;  ///< Q0; to be shown only where `determined` (or given)
  double limit_pm = 0.0;
  double factor = 0.0;  ///< C
  double order = 0.0;   ///< p
  double order_pm = 0.0;
  double scatter = 0.0;  ///< root mean square of what the model leaves in its window, in the unit of Q

  /// Uncertainty of the finest result, in the unit of Q: the exact value lies within finest_pm of it in 95 of 100
  /// cases. A grid convergence index (ASME V&V 20): `safety` times the estimated error, and the scatter. With a known
  /// limit the error is known: NaN.
  double finest_pm = 0.0;
  double safety = 0.0;  ///< 1.25 where the order is determined, 3 elsewhere

  bool determined = false;  ///< whether the data determine p and (if it is not given) the limit; four meshes at least
  std::string remark;       ///< why not
};

/// Fits by least squares over the windows of the finest meshes and chooses one by the data. Known limits are fitted in
/// relative error. `h` and `value` have equal lengths, any order. Throws std::invalid_argument on fewer than two
/// results, on h that are not positive or not distinct, or on values that are not finite.
///
/// Source: Eca and Hoekstra, J. Comput. Phys. 262 (2014) 104; ASME V&V 20-2009.
LimitFit fit_limit(std::span<const double> h, std::span<const double> value, const FitOptions& options = {});

/// The model C x^p fitted to costs over sizes (seconds over unknowns), in relative error: a limit of 0 that p may have
/// any sign for. Costs of 0 are left out. Below three costs over three distinct sizes p is NaN and the remark says so.
/// Determined by four costs or more, where p is known to 0.25. Throws std::invalid_argument on unequal lengths, on x
/// that are not positive, or on costs below 0 or not finite.
LimitFit fit_power(std::span<const double> x, std::span<const double> cost);

}  // namespace cleft::convergence
