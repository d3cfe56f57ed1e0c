#include "unit.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace cleft::report {

Unit unit_for(double largest, const std::string& unit) {
  constexpr std::array kPrefixes{"p", "n", "\u00b5", "m", "", "k", "M", "G", "T"};
  constexpr int kPlain = 4, kLast = static_cast<int>(kPrefixes.size()) - 1;
  if (unit.empty() || !(largest > 0.0)) return {1.0, unit};
  const int power = std::clamp(static_cast<int>(std::floor(std::log10(largest) / 3.0)), -kPlain, kLast - kPlain);
  return {std::pow(1000.0, -power), kPrefixes[static_cast<std::size_t>(power + kPlain)] + unit};
}

double largest_of(const std::vector<double>& values) {
  double largest = 0.0;
  for (const double v : values)
    if (std::isfinite(v)) largest = std::max(largest, std::fabs(v));
  return largest;
}

}  // namespace cleft::report
