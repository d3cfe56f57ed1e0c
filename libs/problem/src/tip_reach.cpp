#include "cleft/problem/tip_reach.hpp"

#include <fmt/format.h>

#include "cleft/assembly/material_point_geometry.hpp"
#include "cleft/geometry/advance.hpp"

namespace cleft::problem {
namespace {

using geometry::TipBall;

constexpr double kWithin = 1.0 - 1e-9;  // of the reach; not on its rim but for rounding

double size_at(const assembly::Model& m, Index tip) { return element_size(m.mesh, m.cut.tips[tip].element); }

void refuse_narrow(const Specification& specification, const assembly::Model& m, Index tip) {
  const TipBall& ball = m.cut.tips[tip];
  const double elements = elements_within_reach(m, tip);
  if (elements >= kLeastReach) return;
  throw InputError(
      specification.cracks[ball.crack].at,
      specification.cracks[ball.crack].at.part("crack", specification.cracks[ball.crack].name),
      fmt::format("its stress intensity factors are asked for, but {:.3g} m from the tip {}, {:.2g} element sizes, {}; "
                  "allowed: at least half an element size, {:.3g} m",
                  ball.reach, m.words_for(ball.frame.tip()), elements, end_of_reach(ball), least_reach(m, tip)));
}

void refuse_short_advances(const Specification& specification, const assembly::Model& m, Index tip) {
  const TipBall& ball = m.cut.tips[tip];
  const auto& crack = specification.cracks[ball.crack];
  if (!grows_by_intensities(crack) || !crack.growth->tips[ball.end] || crack.growth->advance >= least_reach(m, tip))
    return;
  throw InputError(crack.growth_at, crack.growth_at.key("advance"),
                   fmt::format("after an advance the crack bends, and stress intensity factors are taken up to the "
                               "bend; allowed: at least half an element size, {:.3g} m",
                               least_reach(m, tip)));
}

// The interaction integral does not account for the force that holds a node inside its ball.
void refuse_held_nodes(const Specification& specification, const assembly::Model& m, Index tip) {
  const TipBall& ball = m.cut.tips[tip];
  for (std::size_t p = 0; p < m.prescribed.size(); ++p)
    for (const Index unknown : m.prescribed[p].unknowns) {
      const Vec2& X = m.mesh.nodes[m.unknowns.node_of[unknown]];
      if ((X - ball.frame.tip()).norm() >= kWithin * ball.reach) continue;
      throw InputError(
          specification.boundaries[p].at,
          specification.boundaries[p].at.part("boundary", specification.boundaries[p].name),
          fmt::format("holds the node {} in the ball of a tip of crack '{}', whose stress intensity factors are "
                      "asked for; allowed: nodes outside of the ball, or a smaller {}",
                      m.words_for(X), specification.cracks[ball.crack].name,
                      specification.formulation_at.key("tip_enrichment")));
    }
}

}  // namespace

double elements_within_reach(const assembly::Model& m, Index tip) { return m.cut.tips[tip].reach / size_at(m, tip); }

const char* end_of_reach(const TipBall& ball) {
  if (ball.reach == ball.radius) return "the ball of branch functions ends";
  return ball.reach == ball.frame.straight_until() ? "the crack bends" : "the body ends";
}

double least_reach(const assembly::Model& m, Index tip) { return kLeastReach * size_at(m, tip); }

bool spans_elements(const assembly::Model& m, Index crack, int end, double radius) {
  const geometry::Disc disc{geometry::tip_of(m.cracks[crack], end).point, radius};
  return assembly::visit_within(disc, m, [](Index, double) {});
}

bool asks_for_intensities(const CrackSpec& crack, int end) {
  return crack.intensities || (grows_by_intensities(crack) && crack.growth->tips[end]);
}

void refuse_narrow_tips(const Specification& specification, const assembly::Model& m) {
  for (Index tip = 0; tip < static_cast<Index>(m.cut.tips.size()); ++tip) {
    if (!asks_for_intensities(specification.cracks[m.cut.tips[tip].crack], m.cut.tips[tip].end)) continue;
    refuse_narrow(specification, m, tip);
    refuse_short_advances(specification, m, tip);
    refuse_held_nodes(specification, m, tip);
  }
}

}  // namespace cleft::problem
