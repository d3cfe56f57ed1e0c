#include <algorithm>
#include <cmath>

#include "cleft/solve/newton.hpp"

namespace cleft::solve {
namespace {

// A correction that the next one undercuts this many times is none of rounding.
constexpr double kFalls = 10.0;

// A step that gains less than this factor is still on its way: damped steps gain next to nothing, and the full one that
// follows would show any order.
constexpr double kGain = 2.0;

// A displacement gradient of a correction below which its square is small against it.
constexpr double kSmallGradient = 0.1;

// Of three corrections; nothing if the first step did not gain enough.
std::optional<double> order_of(const Iteration* three, double Iteration::*size) {
  const double gained = std::log(three[0].*size / three[1].*size);
  if (!(gained >= std::log(kGain))) return std::nullopt;
  return std::log(three[1].*size / three[2].*size) / gained;
}

}  // namespace

SettledCorrections settled_corrections(std::span<const Iteration> iterations) {
  std::size_t first = 0, end = 0;
  for (std::size_t k = 0; k < iterations.size(); ++k) {
    if (iterations[k].switches()) first = k;
    if (iterations[k].cycles) first = k + 1;
    if (iterations[k].correction > 0.0) end = k + 1;
  }
  for (std::size_t k = first; k < end; ++k)
    if (iterations[k].kept) end = k + 1;
  first = std::min(first, end);
  SettledCorrections out{iterations.subspan(first, end - first)};
  const auto& its = out.all;
  const auto is_clear = [&](std::size_t k) {
    return its[k].residual > its[k].rounding || (k + 1 < its.size() && its[k].gradient > kFalls * its[k + 1].gradient);
  };
  while (out.clear < its.size() && is_clear(out.clear)) ++out.clear;
  if (first + out.clear < iterations.size()) out.next = &iterations[first + out.clear];
  return out;
}

std::optional<ConvergenceOrder> convergence_order(std::span<const Iteration> iterations) {
  const auto [its, clear, next] = settled_corrections(iterations);
  if (clear >= 3) {
    const auto order = order_of(&its[clear - 3], &Iteration::gradient);
    return order ? std::optional(ConvergenceOrder{*order, false}) : std::nullopt;
  }
  if (clear < 2 || its.size() == 2) return std::nullopt;
  const auto bound = std::max(order_of(its.data(), &Iteration::gradient), order_of(its.data(), &Iteration::correction));
  return bound ? std::optional(ConvergenceOrder{*bound, true}) : std::nullopt;
}

std::optional<double> order_at_unit_scale(std::span<const Iteration> iterations) {
  const auto its = settled_corrections(iterations).all;
  if (its.size() < 2 || its[0].residual <= its[0].rounding) return std::nullopt;
  const double first = its[0].gradient, second = its[1].gradient;
  if (!(first < kSmallGradient && second < first && second > 0.0)) return std::nullopt;
  return std::log(second) / std::log(first);
}

}  // namespace cleft::solve
