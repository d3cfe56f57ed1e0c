#include "predicates.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <array>

namespace cleft::geometry {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

int sign_of_difference(double a, double b) { return a > b ? 1 : a < b ? -1 : 0; }

// c is known to be on the line through a and b
bool within_box(const Vec2& a, const Vec2& b, const Vec2& c) {
  return std::min(a.x(), b.x()) <= c.x() && c.x() <= std::max(a.x(), b.x()) && std::min(a.y(), b.y()) <= c.y() &&
         c.y() <= std::max(a.y(), b.y());
}

}  // namespace

int orientation(const Vec2& a, const Vec2& b, const Vec2& c) {
  return static_cast<int>(
      CGAL::orientation(Kernel::Point_2(a.x(), a.y()), Kernel::Point_2(b.x(), b.y()), Kernel::Point_2(c.x(), c.y())));
}

int side_of_shifted_line(const Vec2& p, const Vec2& q, const Vec2& node) {
  // d/de of cross(q - p, node - p - e v) is -cross(q - p, v), for v = (1, 0) and then (0, 1)
  if (const int side = orientation(p, q, node)) return side;
  if (const int side = sign_of_difference(q.y(), p.y())) return side;
  return sign_of_difference(p.x(), q.x());
}

int shifted_side_of_edge(const Vec2& a, const Vec2& b, const Vec2& p) {
  if (const int side = orientation(a, b, p)) return side;
  if (const int side = sign_of_difference(a.y(), b.y())) return side;
  return sign_of_difference(b.x(), a.x());
}

bool segments_meet(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const int ac = orientation(a, b, c), ad = orientation(a, b, d), ca = orientation(c, d, a), cb = orientation(c, d, b);
  if (ac * ad < 0 && ca * cb < 0) return true;
  return (ac == 0 && within_box(a, b, c)) || (ad == 0 && within_box(a, b, d)) || (ca == 0 && within_box(c, d, a)) ||
         (cb == 0 && within_box(c, d, b));
}

bool folds_back(const Vec2& p, const Vec2& v, const Vec2& s) {
  if (orientation(p, v, s) != 0) return false;
  const int axis = p.x() != v.x() ? 0 : 1;
  return (p[axis] > v[axis]) == (s[axis] > v[axis]);
}

namespace {

using Exact = CGAL::Exact_rational;

// The crossing's place on the edge is numerator / denominator; a translation by (1, 0) and (0, 1) adds the second and
// third number to the numerator.
struct Place {
  std::array<Exact, 3> numerator;
  Exact denominator;
};

Place exact_place(const Vec2& a, const Vec2& b, const Line& line) {
  const Exact dx = Exact(line.end.x()) - Exact(line.start.x());
  const Exact dy = Exact(line.end.y()) - Exact(line.start.y());
  const auto left_of = [&](const Vec2& node) -> Exact {
    return dx * (Exact(node.y()) - Exact(line.start.y())) - dy * (Exact(node.x()) - Exact(line.start.x()));
  };
  const Exact at_a = left_of(a);
  return {{at_a, dy, -dx}, at_a - left_of(b)};
}

}  // namespace

double crossing_place(const Vec2& a, const Vec2& b, const Line& line) {
  const Place place = exact_place(a, b, line);
  return CGAL::to_double(Exact(place.numerator[0] / place.denominator));
}

int compare_crossings(const Vec2& a, const Vec2& b, const Line& first, const Line& second) {
  const Place one = exact_place(a, b, first);
  const Place two = exact_place(a, b, second);
  const int flip = static_cast<int>(CGAL::sign(one.denominator)) * static_cast<int>(CGAL::sign(two.denominator));
  for (std::size_t k = 0; k < 3; ++k) {
    const Exact difference = one.numerator[k] * two.denominator - two.numerator[k] * one.denominator;
    if (const int sign = static_cast<int>(CGAL::sign(difference)); sign != 0) return sign * flip;
  }
  return 0;
}

}  // namespace cleft::geometry
