/// \file
/// Things that belong together, found pair by pair.
#pragma once

#include <cstddef>
#include <numeric>
#include <vector>

#include "cleft/support/types.hpp"

namespace cleft {

/// The numbers 0 to count - 1 in sets that are joined two by two; at first each is alone.
class DisjointSets {
 public:
  explicit DisjointSets(Index count) : parent_(static_cast<std::size_t>(count)) {
    std::iota(parent_.begin(), parent_.end(), Index{0});
  }

  /// The number that stands for the set of `k`.
  Index of(Index k) {
    while (parent_[k] != k) k = parent_[k] = parent_[parent_[k]];
    return k;
  }
  void join(Index a, Index b) { parent_[of(a)] = of(b); }

 private:
  std::vector<Index> parent_;
};

}  // namespace cleft
