#include "chatter.hpp"

#include <algorithm>

namespace cleft::assembly {

bool Chatter::halves(int iteration, const Iteration& it) {
  constexpr int kPatience = 4;   // increments that go well have settled by then
  constexpr double kSlow = 0.5;  // times the least residual so far: what does not converge
  const bool slow = it.residual > kSlow * least_;
  if (iteration > 0) least_ = std::min(least_, it.residual);  // a body at rest is in balance before it is moved
  const bool out = iteration >= kPatience && slow && it.status_changes + it.partner_changes > 0;
  halved_ += out;
  return out;
}

}  // namespace cleft::assembly
