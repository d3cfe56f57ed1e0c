/// \file
/// How fast Newton's iteration converged in a run.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cleft/problem/specification.hpp"
#include "cleft/solve/newton.hpp"

namespace cleft::tangent_check {

/// What the settled corrections of an iteration show (solve::settled_corrections). The size of an error is measured in
/// four ways: by the largest displacement gradient of the correction, its largest displacement, the root of its energy
/// and the residual. The order does not depend on which, but three numbers show it only as far as the error keeps its
/// shape.
struct ObservedRate {
  std::size_t corrections = 0;          ///< above rounding
  std::optional<double> order;          ///< the highest of the four
  bool is_bound = false;                ///< too few corrections are above rounding: the order is this or higher
  std::optional<double> at_unit_scale;  ///< solve::order_at_unit_scale
  std::optional<std::array<double, 2>> constants;  ///< g+/g^2 of the last two steps above rounding, g the gradient
  std::optional<std::array<double, 2>> ratios;     ///< g+/g of the same steps
  std::optional<double> least_ratio;  ///< g+/g of the last step above rounding or of the one to rounding, the smaller
  bool starts_at_rounding = false;    ///< the first residual is so near rounding that no order can show
};
ObservedRate observe(const std::vector<solve::Iteration>& iterations);

/// One attempt at an increment of a run.
struct IncrementRate {
  int step = 0;
  double load = 0.0;
  bool failed = false;
  std::vector<solve::Iteration> iterations;  ///< the last one is the residual that was left
  ObservedRate rate;
};

/// Reads newton.csv of a run's folder. Throws std::runtime_error with path and reason.
std::vector<IncrementRate> newton_rates(const std::string& directory);

struct RateRequirement {
  double order = 1.8;  ///< that most increments must show
  double share = 0.9;  ///< of the increments that can be judged
  double least = 1.5;  ///< order that none may fall short of
};

/// What an iteration says of the tangent. With an error of the tangent of relative size q, corrections in the end
/// shrink by q and no more: their ratio stays what it is and g+/g^2 grows by 1/q from step to step.
enum class Finding : std::uint8_t {
  Order,      ///< the required order, by the best of the four sizes
  Linear,     ///< a step that leaves 1e-6 of a correction: the problem is linear, or no error of the tangent is larger
  Constant,   ///< g+/g^2 is bounded: at most 10, or ten times that of the step before, and g+/g falls tenfold
  UnitScale,  ///< two corrections only, the second no larger than the first to the power of the order: no miss can show
  AtRounding,  ///< it begins at rounding, there is nothing to see
  Unknown,     ///< too few corrections
  Missed
};
Finding find(const ObservedRate& rate, const RateRequirement& required);

enum class RateAnswer : std::uint8_t { Holds, Misses, Unknown };

struct RateVerdict {
  std::size_t increments = 0;          ///< that converged
  std::size_t failed = 0;              ///< attempts
  std::array<std::size_t, 7> count{};  ///< by finding, of the increments, and of the failed attempts that miss
  std::array<double, 5> orders{};      ///< known ones of what is judged: lowest, quartiles with median, highest
  std::optional<double> sharpest;  ///< least ratio of corrections that is known: a larger error of the tangent may show
  std::vector<IncrementRate> missed;
  std::vector<IncrementRate> unknown;
  bool ends_in_failure = false;  ///< no increment converged after the last failed attempts
  RateAnswer answer = RateAnswer::Unknown;
  std::string reason;  ///< unless it holds

  std::size_t of(Finding finding) const { return count[static_cast<std::size_t>(finding)]; }
  std::size_t reach() const { return of(Finding::Order) + of(Finding::Linear) + of(Finding::Constant); }
  std::size_t judged() const { return reach() + of(Finding::Missed); }
};
RateVerdict judge(const std::vector<IncrementRate>& rates, const RateRequirement& required);

/// Whether so many increments converge linearly that those to come do not matter: five in a row.
bool is_clearly_linear(const std::vector<IncrementRate>& rates, const RateRequirement& required);

/// The scene with iterations that go on until rounding stops them, and make at least four corrections: little can be
/// said of an iteration that stops after two because they were good enough.
problem::Specification until_rounding(problem::Specification scene);

}  // namespace cleft::tangent_check
