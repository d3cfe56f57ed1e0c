#include "cleft/results/counts.hpp"

#include <algorithm>

namespace cleft::results {
namespace {

void count_rounded(const growth::Step& step, Rounded& rounded) {
  if (!(step.rounded > solve::kUnnoticedResidual)) return;
  ++rounded.increments;
  if (step.rounded <= rounded.worst) return;
  rounded.worst = step.rounded;
  rounded.load = step.load;
}

}  // namespace

void Counts::count(const growth::Step& step) {
  increments = step.number;
  iterations += static_cast<long>(step.iterations.size()) + step.iterations_before;
  cuts += step.cuts;
  worst_residual = std::max(worst_residual, step.left.residual);
  count_rounded(step, rounded);
  if (step.jumped && jumps.increments++ == 0) jumps.load = step.load;
  auto residuals = step.iterations;
  residuals.push_back(step.left);
  if (const auto order = solve::convergence_order(residuals); order && !order->at_least) orders.push_back(order->order);
}

double Counts::median_order() const {
  if (orders.empty()) return 0.0;
  std::vector<double> sorted = orders;
  std::ranges::sort(sorted);
  return sorted[sorted.size() / 2];
}

}  // namespace cleft::results
