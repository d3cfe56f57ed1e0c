#include "chatter.hpp"

#include <algorithm>
#include <utility>

namespace cleft::assembly {

bool Chatter::repeats(std::vector<Index> state, double residual) {
  constexpr double kFalls = 0.5;
  const bool left = !seen_.empty() && seen_.back().state != state;
  const bool back = left && std::ranges::any_of(seen_, [&](const Seen& earlier) {
                      return earlier.state == state && residual >= kFalls * earlier.residual;
                    });
  if (back) seen_.clear();
  seen_.push_back({std::move(state), residual});
  return back;
}

}  // namespace cleft::assembly
