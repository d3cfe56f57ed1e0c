#include "cleft/problem/tip_reach.hpp"

#include <fmt/format.h>

#include "cleft/assembly/material_places.hpp"
#include "cleft/geometry/advance.hpp"

namespace cleft::problem {
namespace {

using geometry::TipBall;

constexpr double kSoundError = 1.0;     // percent
constexpr double kWithin = 1.0 - 1e-9;  // of the reach; not on its rim but for rounding

double size_at(const assembly::Model& m, Index tip) { return element_size(m.mesh, m.cut.tips[tip].element); }

const char* end_of_reach(const TipBall& ball) {
  if (ball.reach == ball.radius) return "the ball of branch functions ends";
  return ball.reach == ball.frame.straight_until() ? "the crack bends" : "the body ends";
}

void refuse_narrow(const Specification& scene, const assembly::Model& m, Index tip) {
  const TipBall& ball = m.cut.tips[tip];
  const double elements = elements_within_reach(m, tip);
  if (elements >= kLeastReach) return;
  throw InputError(
      scene.cracks[ball.crack].at, scene.cracks[ball.crack].at.part("crack", scene.cracks[ball.crack].name),
      fmt::format("its stress intensity factors are asked for, but {:.3g} m from the tip {}, {:.2g} element sizes, {}; "
                  "allowed: at least half an element size, {:.3g} m",
                  ball.reach, m.words_for(ball.frame.tip()), elements, end_of_reach(ball), least_reach(m, tip)));
}

void refuse_short_advances(const Specification& scene, const assembly::Model& m, Index tip) {
  const TipBall& ball = m.cut.tips[tip];
  const auto& crack = scene.cracks[ball.crack];
  if (!grows_by_intensities(crack) || !crack.growth->tips[ball.end] || crack.growth->advance >= least_reach(m, tip))
    return;
  throw InputError(crack.growth_at, crack.growth_at.key("advance"),
                   fmt::format("after an advance the crack bends, and stress intensity factors are taken up to the "
                               "bend; allowed: at least half an element size, {:.3g} m",
                               least_reach(m, tip)));
}

// The force that holds a node inside of the body is none that the integral knows.
void refuse_held_nodes(const Specification& scene, const assembly::Model& m, Index tip) {
  const TipBall& ball = m.cut.tips[tip];
  for (std::size_t p = 0; p < m.prescribed.size(); ++p)
    for (const Index unknown : m.prescribed[p].unknowns) {
      const Vec2& X = m.mesh.nodes[m.unknowns.node_of[unknown]];
      if ((X - ball.frame.tip()).norm() >= kWithin * ball.reach) continue;
      throw InputError(
          scene.boundaries[p].at, scene.boundaries[p].at.part("boundary", scene.boundaries[p].name),
          fmt::format("holds the node {} in the ball of a tip of crack '{}', whose stress intensity factors are "
                      "asked for; allowed: nodes outside of the ball, or a smaller {}",
                      m.words_for(X), scene.cracks[ball.crack].name, scene.formulation_at.key("tip_enrichment")));
    }
}

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

std::string reach_remark(const Specification& scene, const assembly::Model& m, Index tip) {
  const TipBall& ball = m.cut.tips[tip];
  const double elements = elements_within_reach(m, tip);
  std::string out =
      fmt::format("crack '{}': the intensities of the tip {} are taken within {:.3g} m of it, {:.2g} element sizes",
                  scene.cracks[ball.crack].name, m.words_for(ball.frame.tip()), ball.reach, elements);
  if (ball.reach < ball.radius)
    out += fmt::format(", where {} (the ball has {:.3g} m)", end_of_reach(ball), ball.radius);
  const double error = expected_error(m, tip);
  if (elements < kLeastReach)
    out += "; with less than half of one there are none (nan)";
  else if (error > kSoundError)
    out += fmt::format("; expect errors of up to {:g} %, with at least 3 of about {:g} %", error, kSoundError);
  return out;
}

}  // namespace

double elements_within_reach(const assembly::Model& m, Index tip) { return m.cut.tips[tip].reach / size_at(m, tip); }

double least_reach(const assembly::Model& m, Index tip) { return kLeastReach * size_at(m, tip); }

Index ball_at(const assembly::Model& m, Index crack, int end) {
  for (std::size_t tip = 0; tip < m.cut.tips.size(); ++tip)
    if (m.cut.tips[tip].crack == crack && m.cut.tips[tip].end == end) return static_cast<Index>(tip);
  return kNone;
}

bool spans_elements(const assembly::Model& m, Index crack, int end, double radius) {
  const geometry::Disc disc{geometry::tip_of(m.cracks[crack], end).point, radius};
  return assembly::visit_within(disc, m, [](Index, double) {});
}

bool asks_for_intensities(const CrackSpec& crack, int end) {
  return crack.intensities || (grows_by_intensities(crack) && crack.growth->tips[end]);
}

void refuse_narrow_tips(const Specification& scene, const assembly::Model& m) {
  for (Index tip = 0; tip < static_cast<Index>(m.cut.tips.size()); ++tip) {
    if (!asks_for_intensities(scene.cracks[m.cut.tips[tip].crack], m.cut.tips[tip].end)) continue;
    refuse_narrow(scene, m, tip);
    refuse_short_advances(scene, m, tip);
    refuse_held_nodes(scene, m, tip);
  }
}

std::vector<std::string> remarks_on_reach(const Specification& scene, const assembly::Model& m, bool all) {
  std::vector<std::string> out;
  for (Index tip = 0; tip < static_cast<Index>(m.cut.tips.size()); ++tip) {
    const TipBall& ball = m.cut.tips[tip];
    if (!asks_for_intensities(scene.cracks[ball.crack], ball.end)) continue;
    if (expected_error(m, tip) > kSoundError || (all && ball.reach < ball.radius))
      out.push_back(reach_remark(scene, m, tip));
  }
  return out;
}

}  // namespace cleft::problem
