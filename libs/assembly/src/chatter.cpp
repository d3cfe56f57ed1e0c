#include "chatter.hpp"

#include <utility>

namespace cleft::assembly {

bool Chatter::repeats(std::vector<Index> state, double residual) {
  constexpr double kFalls = 0.1;
  seen_.push_back({std::move(state), residual});
  const std::size_t n = seen_.size();
  // two whole rounds, so that a state that is passed twice on the way is none
  if (n < 4) return false;
  const auto same = [&](std::size_t a, std::size_t b) { return seen_[n - a].state == seen_[n - b].state; };
  if (!same(1, 3) || !same(2, 4) || same(1, 2) || residual < kFalls * seen_[n - 3].residual) return false;
  seen_.clear();
  return true;
}

}  // namespace cleft::assembly
