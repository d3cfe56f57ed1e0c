#include "cleft/tangent_check/newton_rate.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "cleft/support/files.hpp"

namespace cleft::tangent_check {

std::vector<IncrementRate> newton_rates(const std::string& directory) {
  const std::string path = directory + "/newton.csv";
  const auto table = read_csv(path);
  const auto column = [&](const char* name) {
    try {
      return table.column(name);
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(path + ": " + error.what());
    }
  };
  const auto step = column("step"), load = column("load"), residual = column("residual"), rounding = column("rounding"),
             correction = column("correction"), gradient = column("gradient"), energy = column("energy"),
             partner = column("partner_changes"), status = column("status_changes"), kept = column("kept");
  std::vector<IncrementRate> rates;
  for (std::size_t k = 0; k < step.size(); ++k) {
    if (rates.empty() || rates.back().step != static_cast<int>(step[k]))
      rates.push_back({static_cast<int>(step[k]), load[k], {}, {}, {}});
    solve::Iteration it;
    it.residual = residual[k];
    it.rounding = rounding[k];
    it.correction = correction[k];
    it.gradient = gradient[k];
    it.energy = energy[k];
    it.partner_changes = static_cast<int>(partner[k]);
    it.status_changes = static_cast<int>(status[k]);
    it.kept = kept[k] != 0.0;
    rates.back().iterations.push_back(it);
  }
  for (auto& rate : rates) {
    rate.order = solve::convergence_order(rate.iterations);
    rate.at_unit_scale = solve::order_at_unit_scale(rate.iterations);
  }
  return rates;
}

RateVerdict judge(const std::vector<IncrementRate>& rates, const RateRequirement& required) {
  RateVerdict out;
  out.increments = rates.size();
  std::vector<double> orders;
  for (const auto& rate : rates) {
    const bool reaches = rate.order && rate.order->order >= required.order;
    if (!reaches && (!rate.order || rate.order->at_least)) {
      if (rate.at_unit_scale && *rate.at_unit_scale >= required.order)
        ++out.scaled;
      else
        out.unjudged.push_back(rate);
      continue;
    }
    orders.push_back(rate.order->order);
    out.reach += reaches;
    out.bounds += rate.order->at_least;
    if (!reaches) out.missed.push_back(rate);
  }
  out.judged = orders.size();
  out.enough = 2 * (out.judged + out.scaled) >= out.increments && out.judged > 0;
  if (orders.empty()) return out;
  std::sort(orders.begin(), orders.end());
  for (std::size_t k = 0; k < out.orders.size(); ++k)
    out.orders[k] = orders[k * (orders.size() - 1) / (out.orders.size() - 1)];
  const double share = static_cast<double>(out.reach) / static_cast<double>(out.judged);
  out.holds = out.enough && share >= required.share && out.lowest() >= required.least;
  return out;
}

problem::Specification until_rounding(problem::Specification scene) {
  auto& solver = scene.solver;
  solver.min_iterations = std::max(solver.min_iterations, 4);
  solver.max_iterations = std::max(solver.max_iterations, solver.min_iterations + 8);
  solver.residual_tolerance = std::numeric_limits<double>::min();  // the level of rounding counts as zero
  return scene;
}

}  // namespace cleft::tangent_check
