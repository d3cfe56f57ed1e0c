#include "bordered.hpp"

namespace cleft::solve {

void Bordered::follow(const VecX& progress, const VecX& by_load) {
  progress_ = &progress;
  along_ = solver_.solve(by_load);
  progress_of_along_ = progress.dot(along_);
}

// theory (9.4)
Correction Bordered::go_on(double c) const {
  const double load = c / progress_of_along_;
  return {load * along_, load};
}

Correction Bordered::solve(const VecX& b) const {
  Correction out{solver_.solve(b)};
  if (!progress_) return out;
  const auto back = go_on(-progress_->dot(out.displacement));
  return {out.displacement + back.displacement, back.load};
}

}  // namespace cleft::solve
