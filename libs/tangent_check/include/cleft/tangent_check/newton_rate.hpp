/// \file
/// How fast Newton's iteration converged in a run.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "cleft/problem/specification.hpp"
#include "cleft/solve/newton.hpp"

namespace cleft::tangent_check {

/// One converged increment of a run.
struct IncrementRate {
  int step = 0;
  double load = 0.0;
  std::vector<solve::Iteration> iterations;  ///< the last one is the residual that was left
  std::optional<solve::ConvergenceOrder> order;
  std::optional<double> at_unit_scale;  ///< solve::order_at_unit_scale
};

/// Reads newton.csv of a run's folder. Throws std::runtime_error with path and reason.
std::vector<IncrementRate> newton_rates(const std::string& directory);

struct RateRequirement {
  double order = 1.8;  ///< that most increments must show
  double share = 0.9;  ///< of the increments that can be judged
  double least = 1.5;  ///< order that none may fall short of
};

/// An increment is judged if its order is known, or if a lower bound of it reaches what is required. Good iterations
/// are over before three corrections show an order: where the order at unit scale reaches what is required it says that
/// an increment need not be worried about, but cannot show a miss, and so counts for `enough` only.
struct RateVerdict {
  std::size_t increments = 0, judged = 0, reach = 0;  ///< those that reach the required order
  std::size_t bounds = 0;                             ///< judged ones of which only a lower bound is known
  std::size_t scaled = 0;                             ///< not judged, but of the required order at unit scale
  std::array<double, 5> orders{};                     ///< of the judged ones: lowest, quartiles with median, highest
  double lowest() const { return orders.front(); }
  std::vector<IncrementRate> missed;  ///< judged and below the required order
  std::vector<IncrementRate> unjudged;
  bool enough = false;  ///< at least half of the increments are judged or of the required order at unit scale
  bool holds = false;
};
RateVerdict judge(const std::vector<IncrementRate>& rates, const RateRequirement& required);

/// The scene with iterations that go on until rounding stops them, and make at least four corrections: little can be
/// said of an iteration that stops after two because they were good enough.
problem::Specification until_rounding(problem::Specification scene);

}  // namespace cleft::tangent_check
