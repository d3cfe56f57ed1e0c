// Random numbers that are the same on every machine.
#pragma once

#include <algorithm>
#include <random>

namespace cleft::verification {

// Distributions of the standard library differ from one to another; its generators do not.
class Dice {
 public:
  explicit Dice(unsigned seed) : generator_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(generator_()) / static_cast<double>(std::mt19937::max());
  }
  int below(int count) { return std::min(count - 1, static_cast<int>(between(0.0, count))); }

 private:
  std::mt19937 generator_;
};

}  // namespace cleft::verification
