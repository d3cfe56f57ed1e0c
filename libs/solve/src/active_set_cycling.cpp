#include "active_set_cycling.hpp"

#include <algorithm>

namespace cleft::solve {
namespace {

constexpr int kPatience = 4;  // iterations: increments that go well have settled by then

}  // namespace

void ActiveSetCycling::look_at(int iteration, const Iteration& it, bool again) {
  constexpr double kSlow = 0.5;  // times the least residual so far: what does not converge
  iteration_ = iteration;
  circles_ = again;
  slow_ = it.residual > kSlow * least_;
  slow_in_a_row_ = slow_ ? slow_in_a_row_ + 1 : 0;
  changes_ = it.status_changes + it.partner_changes > 0;
  since_late_change_ = changes_ && is_late() ? 0 : since_late_change_ + 1;
  since_least_ = it.residual < least_ ? 0 : since_least_ + 1;
  if (iteration > 0) least_ = std::min(least_, it.residual);  // a body at rest is in balance before it is moved
}

bool ActiveSetCycling::is_late() const { return iteration_ >= kPatience; }

bool ActiveSetCycling::halves() {
  const bool out = is_late() && slow_ && changes_ && (circles_ || since_least_ >= kPatience);
  halved_ += out;
  return out;
}

bool ActiveSetCycling::is_over() const {
  constexpr int kProgress = 6;  // iterations in which the residual must fall, and the contact change
  constexpr int kMost = 8;      // times the iterations allowed otherwise
  if (iteration_ < max_iterations_ + std::min(halved_, max_iterations_)) return false;
  const bool zips = since_least_ < kProgress && since_late_change_ < kProgress;
  return !zips || iteration_ >= kMost * max_iterations_;
}

}  // namespace cleft::solve
