#include "cleft/geometry/lines.hpp"

#include <algorithm>
#include <cmath>

#include "cleft/support/error.hpp"

namespace cleft::geometry {
namespace {

// q + q^2 + ... + q^count
double sum_of_powers(double q, int count) {
  double sum = 0.0, power = 1.0;
  for (int k = 0; k < count; ++k) sum += power *= q;
  return sum;
}

// The factor by which `count` intervals after one of size 1 must grow to cover `length`; below 1 where they shrink.
double growth(int count, double length) {
  double low = 0.0, high = 2.0;
  while (sum_of_powers(high, count) < length) high *= 2.0;
  while (high - low > 1e-15 * high) {
    const double middle = 0.5 * (low + high);
    if (middle == low || middle == high) break;
    (sum_of_powers(middle, count) < length ? low : high) = middle;
  }
  return high;
}

// Places beyond `from` on the way to `to`, the last one `to` itself.
std::vector<double> growing(double from, double to, int count, double first, double factor) {
  std::vector<double> out;
  double place = from, size = first;
  for (int k = 1; k < count; ++k) out.push_back(place += (to > from ? 1.0 : -1.0) * (size *= factor));
  if (count > 0) out.push_back(to);
  return out;
}

}  // namespace

std::vector<double> even_lines(double from, double to, int cells) {
  std::vector<double> lines;
  for (int i = 0; i <= cells; ++i) lines.push_back(i == cells ? to : from + (to - from) * i / cells);
  return lines;
}

std::vector<double> graded_lines(double from, double to, int cells, const Focus& focus) {
  const double before = focus.from - from, after = to - focus.to;
  const int sides = (before > 0.0) + (after > 0.0),
            inner = std::max(1, static_cast<int>(std::lround(focus.share * cells)));
  const int outer = cells - inner;
  if (sides == 0) return even_lines(from, to, cells);
  if (outer < sides) throw InputError({}, "share", "leaves no cells outside of the focus; allowed: a smaller share");
  const double size = (focus.to - focus.from) / inner;
  // divided so that both sides grow alike
  int left = before > 0.0 ? (after > 0.0 ? 1 : outer) : 0;
  for (int most = outer - 1; sides == 2 && left < most;) {
    const int middle = (left + most) / 2;
    if (growth(middle, before / size) > growth(outer - middle, after / size))
      left = middle + 1;
    else
      most = middle;
  }
  const double grow_left = left > 0 ? growth(left, before / size) : 1.0,
               grow_right = outer > left ? growth(outer - left, after / size) : 1.0;
  if (std::min(grow_left, grow_right) < 1.0 - 1e-9)
    throw InputError({}, "share", "makes the cells outside of the focus smaller than inside; allowed: a larger share");
  std::vector<double> lines = growing(focus.from, from, left, size, grow_left);
  std::reverse(lines.begin(), lines.end());
  const auto inside = even_lines(focus.from, focus.to, inner),
             beyond = growing(focus.to, to, outer - left, size, grow_right);
  lines.insert(lines.end(), inside.begin(), inside.end());
  lines.insert(lines.end(), beyond.begin(), beyond.end());
  return lines;
}

}  // namespace cleft::geometry
