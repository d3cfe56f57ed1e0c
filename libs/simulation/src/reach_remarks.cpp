#include "reach_remarks.hpp"

#include <fmt/format.h>

#include "cleft/problem/tip_reach.hpp"

namespace cleft::simulation {
namespace {

using problem::elements_within_reach, problem::kLeastReach, problem::kSoundReach;

constexpr double kSoundError = 1.0;  // percent

// By what intensities may be off at most, in percent: as seen on the exact field (tools/docs/pages/tips.md).
double expected_error(const assembly::Model& m, Index tip) {
  constexpr double kTiny = 2.0;  // element sizes of a ball whose functions do not reach beyond the tip's neighbours
  const double elements = elements_within_reach(m, tip);
  const double radius = elements * m.cut.tips[tip].radius / m.cut.tips[tip].reach;
  if (elements < kLeastReach) return 100.0;
  if (radius < kTiny) return 50.0;
  if (m.unknowns.blunting > 0.0 && elements < kSoundReach) return 10.0;
  return radius < kSoundReach ? 4.0 : 1.0;
}

std::string remark_on_tip(const problem::Specification& specification, const assembly::Model& m, Index tip) {
  const geometry::TipBall& ball = m.cut.tips[tip];
  const double elements = elements_within_reach(m, tip);
  std::string out =
      fmt::format("crack '{}': the intensities of the tip {} are taken within {:.3g} m of it, {:.2g} element sizes",
                  specification.cracks[ball.crack].name, m.words_for(ball.frame.tip()), ball.reach, elements);
  if (ball.reach < ball.radius)
    out += fmt::format(", where {} (the ball has {:.3g} m)", problem::end_of_reach(ball), ball.radius);
  const double error = expected_error(m, tip);
  if (elements < kLeastReach)
    out += "; with less than half of one there are none (nan)";
  else if (error > kSoundError)
    out += fmt::format("; expect errors of up to {:g} %, with at least 3 of about {:g} %", error, kSoundError);
  return out;
}

template <class Deserves>
std::vector<std::string> remarks_on_tips(const problem::Specification& specification, const assembly::Model& m,
                                         const Deserves& deserves) {
  std::vector<std::string> out;
  for (Index tip = 0; tip < static_cast<Index>(m.cut.tips.size()); ++tip) {
    const auto& ball = m.cut.tips[tip];
    if (problem::asks_for_intensities(specification.cracks[ball.crack], ball.end) && deserves(tip))
      out.push_back(remark_on_tip(specification, m, tip));
  }
  return out;
}

}  // namespace

std::vector<std::string> remarks_on_small_reach(const problem::Specification& specification, const assembly::Model& m) {
  return remarks_on_tips(specification, m, [&](Index tip) { return expected_error(m, tip) > kSoundError; });
}

std::vector<std::string> remarks_on_reach(const problem::Specification& specification, const assembly::Model& m) {
  return remarks_on_tips(specification, m, [&](Index tip) {
    return expected_error(m, tip) > kSoundError || m.cut.tips[tip].reach < m.cut.tips[tip].radius;
  });
}

}  // namespace cleft::simulation
