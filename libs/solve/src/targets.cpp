#include "targets.hpp"

#include <algorithm>
#include <cmath>

namespace cleft::solve {
namespace {

constexpr double kRounding = 1e-6;  // of loads written with six decimals

std::vector<double> ascending(std::vector<double> loads) {
  std::sort(loads.begin(), loads.end());
  loads.erase(std::unique(loads.begin(), loads.end(), [](double a, double b) { return b - a < kLoadResolution; }),
              loads.end());
  return loads;
}

}  // namespace

bool has_near(const std::vector<double>& loads, double load, double within) {
  return std::any_of(loads.begin(), loads.end(), [&](double l) { return std::fabs(l - load) <= within; });
}

bool turns_at(const StepControls& controls, double load) { return has_near(controls.kinks, load, kRounding); }

std::vector<double> marks_of(const StepControls& controls) {
  std::vector<double> all = controls.outputs;
  for (const double kink : controls.kinks)
    if (kink < 1.0 - kRounding && !has_near(controls.outputs, kink, kRounding)) all.push_back(kink);
  return ascending(std::move(all));
}

std::vector<double> targets_of(const StepControls& controls, const std::vector<double>& marks) {
  std::vector<double> all = marks;
  const double planned = 1.0 / controls.steps;
  for (int k = 1; k < controls.steps && controls.accuracy == 0.0; ++k)
    if (const double load = static_cast<double>(k) / controls.steps; !has_near(marks, load, kGivesWay * planned))
      all.push_back(load);
  all.push_back(1.0);
  all = ascending(std::move(all));
  all.back() = 1.0;
  return all;
}

double first_beyond(const std::vector<double>& loads, double load) {
  const auto at = std::upper_bound(loads.begin(), loads.end(), load + kLoadResolution);
  return at == loads.end() ? 1.0 : *at;
}

double interval_around(const std::vector<double>& loads, double load) {
  const auto next = std::upper_bound(loads.begin(), loads.end(), load + kLoadResolution);
  return (next == loads.end() ? 1.0 : *next) - (next == loads.begin() ? 0.0 : *std::prev(next));
}

}  // namespace cleft::solve
