#include "cleft/convergence/curve_distance.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace cleft::convergence {
namespace {

struct Point {
  double place, value;
};

// The points that count, in ascending order; of several at one place the mean.
std::vector<Point> ordered(const Curve& curve) {
  std::vector<Point> points;
  for (std::size_t k = 0; k < curve.place.size(); ++k)
    if (std::isfinite(curve.place[k]) && std::isfinite(curve.value[k]))
      points.push_back({curve.place[k], curve.value[k]});
  std::sort(points.begin(), points.end(), [](const Point& a, const Point& b) { return a.place < b.place; });
  std::vector<Point> out;
  for (std::size_t k = 0; k < points.size();) {
    double sum = 0.0;
    std::size_t end = k;
    for (; end < points.size() && points[end].place == points[k].place; ++end) sum += points[end].value;
    out.push_back({points[k].place, sum / static_cast<double>(end - k)});
    k = end;
  }
  return out;
}

double at(const std::vector<Point>& points, double x) {
  const auto after =
      std::lower_bound(points.begin(), points.end(), x, [](const Point& p, double place) { return p.place < place; });
  if (after == points.begin()) return points.front().value;
  if (after == points.end()) return points.back().value;
  const auto& [x1, v1] = *after;
  const auto& [x0, v0] = *(after - 1);
  return v0 + (v1 - v0) * (x - x0) / (x1 - x0);
}

}  // namespace

std::optional<std::array<double, 2>> common_range(const Curve& a, const Curve& b) {
  const auto p = ordered(a), q = ordered(b);
  if (p.empty() || q.empty()) return std::nullopt;
  const double low = std::max(p.front().place, q.front().place), high = std::min(p.back().place, q.back().place);
  if (!(low < high)) return std::nullopt;
  return std::array{low, high};
}

CurveDistance distance(const Curve& a, const Curve& b, const std::array<double, 2>& range) {
  const auto p = ordered(a), q = ordered(b);
  if (p.empty() || q.empty()) throw std::invalid_argument("a curve has no points");
  if (!(range[0] < range[1])) throw std::invalid_argument("the interval of a distance is empty");
  std::vector<double> cuts{range[0], range[1]};
  for (const auto* points : {&p, &q})
    for (const auto& point : *points)
      if (point.place > range[0] && point.place < range[1]) cuts.push_back(point.place);
  std::sort(cuts.begin(), cuts.end());
  CurveDistance out;
  double norm = 0.0, most = 0.0;
  for (std::size_t k = 0; k < cuts.size(); ++k) {
    const double right = at(q, cuts[k]), d_right = at(p, cuts[k]) - right;
    out.largest = std::max(out.largest, std::fabs(d_right));
    most = std::max(most, std::fabs(right));
    if (k == 0) continue;
    const double left = at(q, cuts[k - 1]), d_left = at(p, cuts[k - 1]) - left;
    const double third = (cuts[k] - cuts[k - 1]) / 3.0;  // both are linear in between
    out.l2 += third * (d_left * d_left + d_left * d_right + d_right * d_right);
    norm += third * (left * left + left * right + right * right);
  }
  out.l2 = std::sqrt(out.l2);
  out.l2_relative = norm > 0.0 ? out.l2 / std::sqrt(norm) : 0.0;
  out.largest_relative = most > 0.0 ? out.largest / most : 0.0;
  return out;
}

}  // namespace cleft::convergence
