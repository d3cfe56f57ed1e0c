#include "cleft/contact/law.hpp"

#include <cmath>

namespace cleft::contact {

// theory (7.1), (7.2)
Traction traction(const Law& law, double normal_gap, double tangential_gap, bool anchored, Touch touch) {
  // A point that was in touch and sits at the rounding of zero keeps its stiffness, so that closed faces at rest are
  // closed.
  if (normal_gap >= (anchored ? touch.length : 0.0)) return {};
  const double normal = law.normal_penalty * normal_gap;
  if (!anchored) return {Status::Stick, normal, 0.0};
  const double trial = law.tangential_penalty * tangential_gap;
  const double strength = law.friction * std::fmax(0.0, -normal);
  if (std::fabs(trial) <= strength + law.tangential_penalty * touch.length) return {Status::Stick, normal, trial};
  return {Status::Slip, normal, std::copysign(strength, tangential_gap)};
}

}  // namespace cleft::contact
