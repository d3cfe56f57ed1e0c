#include <algorithm>
#include <cmath>

#include "cleft/geometry/advance.hpp"
#include "cleft/growth/criterion.hpp"
#include "cleft/growth/intensities.hpp"
#include "cleft/problem/tip_reach.hpp"

namespace cleft::growth {

// theory (10.3), (10.4)
HoopDirection largest_hoop_stress(const enrichment::Intensities& k) {
  const double k1 = std::max(0.0, k.K_I), k2 = k.K_II;
  // tan(t/2), written so that K_II may vanish
  const double tangent = k2 == 0.0 ? 0.0 : -2.0 * k2 / (k1 + std::sqrt(k1 * k1 + 8.0 * k2 * k2));
  const double half = std::atan(tangent), c = std::cos(half);
  return {2.0 * half, c * c * (k1 * c - 3.0 * k2 * std::sin(half))};
}

Demand judge(const problem::HoopStress& criterion, const assembly::Equilibrium& body, const TipName& tip) {
  Demand out;
  const Index ball = geometry::ball_at(body.model.cut, tip.crack, tip.end);
  out.intensities = intensities_by_integral(body, ball);
  out.elements = problem::elements_within_reach(body.model, ball);
  if (std::isnan(out.intensities.K_I)) {
    out.ratio = Demand::kUnknown;
    return out;
  }
  const HoopDirection largest = largest_hoop_stress(out.intensities);
  out.ratio = largest.intensity / criterion.toughness;
  const Vec2 ahead = geometry::tip_of(body.model.cracks[tip.crack], tip.end).ahead;
  out.ahead = std::cos(largest.turn) * ahead + std::sin(largest.turn) * turn_left(ahead);
  return out;
}

}  // namespace cleft::growth
