#include "order.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace cleft::verification {

double order_of(const std::vector<double>& h, const std::vector<double>& error) {
  const auto n = static_cast<double>(h.size());
  double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
  for (std::size_t k = 0; k < h.size(); ++k) {
    const double a = std::log(h[k]), b = std::log(error[k]);
    x += a / n;
    y += b / n;
    xx += a * a / n;
    xy += a * b / n;
  }
  return (xy - x * y) / (xx - x * x);
}

namespace {

TEST(Order, IsTheSlopeOfTheLineThroughTheLogarithms) {
  EXPECT_NEAR(order_of({0.4, 0.1}, {3.0 * 0.16, 3.0 * 0.01}), 2.0, 1e-14);
  // the middle one of three evenly spaced levels does not turn the line
  EXPECT_NEAR(order_of({4.0, 2.0, 1.0}, {8.0, 5.0, 0.5}), 2.0, 1e-14);
}

}  // namespace
}  // namespace cleft::verification
