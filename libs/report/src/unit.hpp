// Units with the prefix that keeps numbers readable.
#pragma once

#include <string>
#include <vector>

namespace cleft::report {

struct Unit {
  double scale = 1.0;  ///< number shown = number in SI times this
  std::string name;
  /// "quantity, unit".
  std::string label(const std::string& quantity) const { return name.empty() ? quantity : quantity + ", " + name; }
};

/// For numbers up to `largest` in the SI unit `unit`; numbers without a unit stay as they are.
Unit unit_for(double largest, const std::string& unit);

/// Largest absolute value of the finite ones, or 0.
double largest_of(const std::vector<double>& values);

}  // namespace cleft::report
