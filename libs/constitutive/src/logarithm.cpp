#include "cleft/constitutive/logarithm.hpp"

#include <cmath>

namespace cleft::constitutive {

double atanh_remainder(double r) {
  constexpr double kSeriesLimit =
      0.1;  // 16 terms leave 0.1^16; beyond it the difference below loses a digit and a half
  if (r < kSeriesLimit) {
    double sum = 0.0;
    for (int k = 16; k >= 1; --k) sum = sum * r + 1.0 / (2 * k + 1);
    return sum;
  }
  const double root = std::sqrt(r);
  return (std::atanh(root) / root - 1.0) / r;
}

}  // namespace cleft::constitutive
