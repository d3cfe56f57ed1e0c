#include "cleft/results/critical_points.hpp"

#include <algorithm>
#include <cmath>

namespace cleft::results {
namespace {

using Kind = CriticalPoint::Kind;

struct Course {
  std::vector<double> step, load, sign;
  std::size_t size() const { return load.size(); }
};

// Rows from which the load goes the other way. What changes it by less than 1e-6 of the largest is no way.
std::vector<std::size_t> turns(const Course& c) {
  double largest = 0.0;
  for (const double load : c.load) largest = std::max(largest, std::fabs(load));
  std::vector<std::size_t> out;
  double way = 1.0;
  std::size_t furthest = 0;  // on this way
  for (std::size_t k = 1; k < c.size(); ++k) {
    if ((c.load[k] - c.load[furthest]) * way > 0.0) {
      furthest = k;
    } else if ((c.load[furthest] - c.load[k]) * way > 1e-6 * largest) {
      out.push_back(furthest);
      way = -way;
      furthest = k;
    }
  }
  return out;
}

// The determinant changes its sign in the increment to a limit point or in one of the next.
bool is_near(const std::vector<std::size_t>& turns, std::size_t row) {
  return std::ranges::any_of(turns, [&](std::size_t turn) { return row + 1 >= turn && row <= turn + 2; });
}

}  // namespace

std::vector<CriticalPoint> critical_points(const CsvTable& history) {
  const Course c{history.column("step"), history.column("load"), history.column("determinant_sign")};
  const auto limits = turns(c);
  std::vector<CriticalPoint> out;
  for (std::size_t k = 0; k < limits.size(); ++k) {
    const std::size_t row = limits[k];
    out.push_back({k % 2 == 0 ? Kind::Maximum : Kind::Minimum, c.load[row], row > 0 ? c.load[row - 1] : 0.0,
                   std::lround(c.step[row])});
  }
  CriticalPoint last{Kind::Bifurcation};  // row whose sign is known: the body at rest is stable
  double sign = 1.0;
  for (std::size_t k = 0; k < c.size(); ++k) {
    if (std::isnan(c.sign[k])) continue;
    const CriticalPoint now{Kind::Bifurcation, c.load[k], last.load, std::lround(c.step[k])};
    if (sign * c.sign[k] < 0.0 && !is_near(limits, k)) out.push_back(now);
    last = now;
    sign = c.sign[k];
  }
  std::ranges::stable_sort(out, {}, &CriticalPoint::step);
  return out;
}

const char* name_of(Kind kind) {
  switch (kind) {
    case Kind::Maximum:
      return "maximum";
    case Kind::Minimum:
      return "minimum";
    case Kind::Bifurcation:
      return "bifurcation";
  }
  return "";
}

}  // namespace cleft::results
