#include "judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "cleft/convergence/fit.hpp"

namespace cleft::objectivity {
namespace {

constexpr std::size_t kLeastMeshes = 3;

void fit_order(Judgement& of) {
  of.order = of.order_pm = std::numeric_limits<double>::quiet_NaN();
  const bool positive = std::ranges::all_of(of.difference, [](double x) { return x > 0.0; });
  if (of.h.size() < kLeastMeshes || !positive) return;
  const auto fit = convergence::fit_limit(of.h, of.difference, {.limit = 0.0});
  of.order = fit.order;
  of.order_pm = fit.order_pm;
}

void judge(Judgement& of, double tolerance, double least_order) {
  const double finest = of.difference.back();
  const auto say = [&](Verdict verdict, std::string reason) {
    of.verdict = verdict;
    of.reason = std::move(reason);
  };
  if (std::isnan(finest)) {
    of.reason = "nothing is in contact";
    return;
  }
  if (finest <= tolerance) return say(Verdict::Holds, fmt::format("within {:g}", tolerance));
  if (of.order - of.order_pm >= least_order)
    return say(Verdict::Holds, fmt::format("falls, order {:.2f} +- {:.2f}", of.order, of.order_pm));
  say(Verdict::Fails,
      fmt::format("above {:g}{}", tolerance,
                  of.h.size() < kLeastMeshes ? "; three meshes show whether it falls"
                                             : fmt::format(", and no order of {:g} for certain", least_order)));
}

std::vector<Solution> back_pair(const Solution& solution, const std::vector<Solution>& turned) {
  const auto same = std::ranges::find(turned, solution.side, &Solution::side);
  return same == turned.end() ? std::vector<Solution>{} : std::vector{solution, *same};
}

// The larger; what is not there leaves the other.
double larger(double a, double b) { return std::isnan(a) || b > a ? b : a; }

}  // namespace

const char* name_of(Verdict verdict) {
  return verdict == Verdict::Holds ? "holds" : verdict == Verdict::Fails ? "does not hold" : "cannot tell";
}

std::vector<Judgement> judge_sides(const std::vector<SwapMesh>& meshes, const SwapOptions& options) {
  std::vector<Judgement> out;
  for (const auto& mesh : meshes)
    for (std::size_t k = 0; k < mesh.differences.size(); ++k) {
      if (out.size() <= k) out.push_back({mesh.differences[k].quantity, {}, {}, 0.0, 0.0, std::nullopt, ""});
      out[k].h.push_back(mesh.h);
      out[k].difference.push_back(mesh.differences[k].largest());
    }
  const auto with = std::ranges::find_if(meshes, [](const auto& mesh) { return !mesh.differences.empty(); });
  for (std::size_t k = 0; k < out.size(); ++k) {
    fit_order(out[k]);
    if (with->differences[k].judged) judge(out[k], options.tolerance, options.least_order);
  }
  return out;
}

std::vector<Judgement> judge_turn(const SwapMesh& mesh, const std::vector<Solution>& turned, const ContactPart& part) {
  std::vector<Judgement> out;
  for (const auto& solution : mesh.solutions) {
    const auto pair = back_pair(solution, turned);
    if (pair.empty()) continue;
    const auto all = differences(pair, part);
    for (std::size_t k = 0; k < all.size(); ++k) {
      if (out.size() <= k) out.push_back({all[k].quantity, {mesh.h}, {all[k].largest()}, 0.0, 0.0, std::nullopt, ""});
      out[k].difference[0] = larger(out[k].difference[0], all[k].largest());
    }
  }
  for (auto& of : out) {
    fit_order(of);
    judge(of, kTurnTolerance, std::numeric_limits<double>::infinity());
    if (of.verdict == Verdict::Fails) of.reason = fmt::format("above {:g}", kTurnTolerance);
  }
  return out;
}

Verdict verdict_of(const SwapResult& result) {
  bool fails = false, pressed = false;
  for (const auto* all : {&result.sides, &result.turn})
    for (const auto& of : *all) {
      fails |= of.verdict == Verdict::Fails;
      pressed |= of.quantity.starts_with("pressure ") && of.verdict.has_value();
    }
  return fails ? Verdict::Fails : pressed && result.failed.empty() ? Verdict::Holds : Verdict::Unknown;
}

}  // namespace cleft::objectivity
