#include "cleft/problem/specification.hpp"

#include <algorithm>
#include <cmath>

namespace cleft::problem {

double Amplitude::operator()(double load) const {
  if (load <= points.front()[0]) return points.front()[1];
  for (std::size_t k = 1; k < points.size(); ++k) {
    const auto &a = points[k - 1], &b = points[k];
    if (load <= b[0]) return a[1] + (b[1] - a[1]) * (load - a[0]) / (b[0] - a[0]);
  }
  return points.back()[1];
}

std::vector<double> Amplitude::turns() const {
  constexpr double kSameSlope = 1e-9;      // of points that lie on a line but for rounding
  const auto slope = [&](std::size_t k) {  // before the point k
    if (k == 0 || k == points.size()) return 0.0;
    return (points[k][1] - points[k - 1][1]) / (points[k][0] - points[k - 1][0]);
  };
  std::vector<double> out;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const double load = points[k][0], before = slope(k), after = slope(k + 1);
    const double steepest = std::max(std::fabs(before), std::fabs(after));
    if (load > 0.0 && load < 1.0 && std::fabs(after - before) > kSameSlope * steepest) out.push_back(load);
  }
  return out;
}

bool is_plastic(const MaterialSpec& m) { return m.model == "j2" || m.model == "drucker-prager"; }
bool is_viscous(const MaterialSpec& m) { return m.viscosity > 0.0; }

bool grows(const Specification& specification) {
  return std::ranges::any_of(specification.cracks, [](const CrackSpec& crack) { return crack.growth.has_value(); });
}
bool grows_by_intensities(const CrackSpec& crack) {
  return crack.growth && std::holds_alternative<HoopStress>(crack.growth->criterion);
}

std::array<bool, 2> BoundarySpec::components() const {
  const bool both = affine || field || rotation;
  return {both || ux.has_value(), both || uy.has_value()};
}

}  // namespace cleft::problem
