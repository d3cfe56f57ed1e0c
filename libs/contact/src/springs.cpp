#include "cleft/contact/springs.hpp"

#include <cmath>

namespace cleft::contact {

// theory (7.1), (7.2)
ContactResponse respond(const InterfaceLaw& law, const Springs& springs, const Gaps& gaps, Touch touch,
                        const InterfaceState& begin) {
  ContactResponse out{{}, {}, begin};
  // A point that was in touch and sits at the rounding of zero keeps its stiffness, so that closed faces at rest are
  // closed.
  if (gaps.normal >= (gaps.anchored ? touch.length : 0.0)) return out;
  const double normal = springs.normal * gaps.normal;
  out.traction = {Status::Stick, normal, 0.0};
  out.stiffness.normal = springs.normal;
  if (!gaps.anchored) return out;
  const double trial = springs.tangential * gaps.tangential;
  const Strength limit = strength(law, std::fmax(0.0, -normal), begin);
  if (std::fabs(trial) <= limit.value + springs.tangential * touch.length) {
    out.traction.tangential = trial;
    out.stiffness.tangential = springs.tangential;
    return out;
  }
  out.traction.status = Status::Slip;
  out.traction.tangential = std::copysign(limit.value, gaps.tangential);
  out.stiffness.by_normal = -std::copysign(limit.by_pressure, out.traction.tangential);
  out.end.slip += std::fabs(gaps.tangential - out.traction.tangential / springs.tangential);
  return out;
}

}  // namespace cleft::contact
