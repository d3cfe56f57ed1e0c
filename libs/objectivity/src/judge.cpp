#include "judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "cleft/convergence/fit.hpp"

namespace cleft::objectivity {
namespace {

constexpr std::size_t kLeastMeshes = 4;  // of which a fit may determine an order
constexpr double kGross = 10.0;          // times the tolerance: below as many meshes a larger difference is a miss

// None where a difference is 0 or not there.
std::optional<convergence::LimitFit> fit_order(Judgement& of) {
  of.order = of.order_pm = std::numeric_limits<double>::quiet_NaN();
  const bool positive = std::ranges::all_of(of.difference, [](double x) { return x > 0.0; });
  if (of.h.size() < 2 || !positive) return std::nullopt;
  auto fit = convergence::fit_limit(of.h, of.difference, {.limit = 0.0});
  of.order = fit.order;
  of.order_pm = fit.order_pm;
  return fit;
}

void say(Judgement& of, Verdict verdict, std::string reason) {
  of.verdict = verdict;
  of.reason = std::move(reason);
}

// Of a difference above the tolerance, on as many meshes as may determine an order.
void judge_fall(Judgement& of, const std::optional<convergence::LimitFit>& fit, const SwapOptions& options) {
  const std::string above = fmt::format("above {:g}", options.tolerance);
  if (fit && fit->kind == convergence::SeriesClass::Diverging)
    return say(of, Verdict::Fails, above + ", and does not get smaller on the finest meshes");
  if (of.difference.back() >= of.difference.front())
    return say(of, Verdict::Fails, above + ", and the finest mesh has no smaller one than the coarsest");
  if (!fit) return say(of, Verdict::Unknown, above + ", and there is no order of differences that are 0 or missing");
  const std::string order = fmt::format("order {:.2f} +- {:.2f}", fit->order, fit->order_pm);
  if (fit->order + fit->order_pm < options.least_order) return say(of, Verdict::Fails, above + "; falls, " + order);
  if (!fit->determined) return say(of, Verdict::Unknown, fmt::format("{}, and {}", above, fit->remark));
  if (fit->order - fit->order_pm < options.least_order) return say(of, Verdict::Unknown, above + "; falls, " + order);
  say(of, Verdict::Holds, "falls, " + order);
}

void judge(Judgement& of, const std::optional<convergence::LimitFit>& fit, const SwapOptions& options) {
  const double finest = of.difference.back();
  if (finest <= options.tolerance) return say(of, Verdict::Holds, fmt::format("within {:g}", options.tolerance));
  if (of.h.size() >= kLeastMeshes) return judge_fall(of, fit, options);
  if (finest > kGross * options.tolerance)
    return say(of, Verdict::Fails, fmt::format("above {:g} times {:g}", kGross, options.tolerance));
  say(of, Verdict::Unknown,
      fmt::format("above {:g}; {} meshes or more may show that it falls", options.tolerance, kLeastMeshes));
}

// A turn changes no mesh: no finer one makes up for what differs.
void judge_rounding(Judgement& of) {
  const bool holds = of.difference.back() <= kTurnTolerance;
  say(of, holds ? Verdict::Holds : Verdict::Fails, fmt::format("{} {:g}", holds ? "within" : "above", kTurnTolerance));
}

// Whether there is nothing to judge, and why.
bool is_not_there(Judgement& of, const Difference& finest) {
  if (!std::isnan(of.difference.back())) return false;
  of.reason = "nothing is in contact";
  if (!finest.doubt.empty()) say(of, Verdict::Unknown, finest.doubt);
  return true;
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
  const auto with = std::find_if(meshes.rbegin(), meshes.rend(), [](const auto& m) { return !m.differences.empty(); });
  for (std::size_t k = 0; k < out.size(); ++k) {
    const auto fit = fit_order(out[k]);
    const Difference& finest = with->differences[k];
    if (finest.judged && !is_not_there(out[k], finest)) judge(out[k], fit, options);
  }
  return out;
}

std::vector<Judgement> judge_turn(const SwapMesh& mesh, const std::vector<Solution>& turned, const ContactPart& part) {
  std::vector<Judgement> out;
  std::vector<Difference> all;
  for (const auto& solution : mesh.solutions) {
    const auto pair = back_pair(solution, turned);
    if (pair.empty()) continue;
    all = differences(pair, part);
    for (std::size_t k = 0; k < all.size(); ++k) {
      if (out.size() <= k) out.push_back({all[k].quantity, {mesh.h}, {all[k].largest()}, 0.0, 0.0, std::nullopt, ""});
      out[k].difference[0] = larger(out[k].difference[0], all[k].largest());
    }
  }
  for (std::size_t k = 0; k < out.size(); ++k) {
    fit_order(out[k]);
    if (!is_not_there(out[k], all[k])) judge_rounding(out[k]);
  }
  return out;
}

Verdict verdict_of(const SwapResult& result) {
  bool fails = false, unknown = !result.failed.empty(), pressed = false;
  for (const auto* all : {&result.sides, &result.turn})
    for (const auto& of : *all) {
      fails |= of.verdict == Verdict::Fails;
      unknown |= of.verdict == Verdict::Unknown;
      pressed |= of.quantity.starts_with("pressure ") && of.verdict.has_value();
    }
  return fails ? Verdict::Fails : unknown || !pressed ? Verdict::Unknown : Verdict::Holds;
}

}  // namespace cleft::objectivity
