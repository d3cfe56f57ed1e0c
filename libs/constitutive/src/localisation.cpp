#include "cleft/constitutive/localisation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

namespace cleft::constitutive {
namespace {

// Coefficients in ascending order of the powers; degree at most four.
using Polynomial = std::array<double, 5>;

double value_at(const Polynomial& p, double t) {
  double sum = 0.0;
  for (auto c = p.rbegin(); c != p.rend(); ++c) sum = sum * t + *c;
  return sum;
}

Polynomial derivative(const Polynomial& p) { return {p[1], 2.0 * p[2], 3.0 * p[3], 4.0 * p[4], 0.0}; }

// Up to four roots and the two ends of the interval, ascending.
struct Knots {
  std::array<double, 6> at{};
  int count = 0;
  void add(double t) { at[static_cast<std::size_t>(count++)] = t; }
};

// The root of p between two points at which it has different signs.
double root_between(const Polynomial& p, const Polynomial& slope, double low, double high) {
  const bool rises = value_at(p, high) > 0.0;
  double t = 0.5 * (low + high);
  for (int iteration = 0; iteration < 100; ++iteration) {
    const double value = value_at(p, t);
    ((value > 0.0) == rises ? high : low) = t;
    const double newton = t - value / value_at(slope, t);
    const double next = newton > low && newton < high ? newton : 0.5 * (low + high);
    if (std::abs(next - t) <= 1e-15) return next;
    t = next;
  }
  return t;
}

// Roots of p in the interval at which it changes sign, between the two ends. Between neighbouring roots of its
// derivative a polynomial is monotonic, so that each such piece holds one root or none.
Knots roots_and_ends(const Polynomial& p, double low, double high, int degree) {
  if (degree == 0) return {{low, high}, 2};
  const Polynomial slope = derivative(p);
  const Knots pieces = roots_and_ends(slope, low, high, degree - 1);
  Knots out;
  out.add(low);
  for (std::size_t k = 0; k + 1 < static_cast<std::size_t>(pieces.count); ++k) {
    const double left = pieces.at[k], right = pieces.at[k + 1];
    if ((value_at(p, left) > 0.0) != (value_at(p, right) > 0.0)) out.add(root_between(p, slope, left, right));
  }
  out.add(high);
  return out;
}

// det Q along n = (1, t), without the factor (1 + t^2)^-2.
Polynomial acoustic_quartic(const Mat4& c) {
  const Mat2 q0 = c.topLeftCorner<2, 2>(), q2 = c.bottomRightCorner<2, 2>();
  const Mat2 q1 = c.topRightCorner<2, 2>() + c.bottomLeftCorner<2, 2>();
  const auto entry = [&](int i, int k) { return std::array{q0(i, k), q1(i, k), q2(i, k)}; };
  const auto q11 = entry(0, 0), q22 = entry(1, 1), q12 = entry(0, 1), q21 = entry(1, 0);
  Polynomial p{};
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t b = 0; b < 3; ++b) p[a + b] += q11[a] * q22[b] - q12[a] * q21[b];
  return p;
}

// theory (5.11), the numerator of the derivative of P/(1 + t^2)^2; its fifth power cancels.
Polynomial stationarity(const Polynomial& p) {
  return {p[1], 2.0 * p[2] - 4.0 * p[0], 3.0 * p[3] - 3.0 * p[1], 4.0 * p[4] - 2.0 * p[2], -p[3]};
}

double degrees(double radians) { return radians * (180.0 / std::numbers::pi); }

// Stationary directions of two charts that overlap, n = (1, t) and n = (t, 1), and the angle 0.
struct Candidates {
  std::array<Localisation, 9> all{};
  std::size_t count = 0;

  void add(double value, double angle) {
    if (angle < 0.0) angle += 180.0;
    if (angle >= 180.0) angle -= 180.0;
    all[count++] = {value, angle};
  }
};

void add_chart(const Polynomial& p, bool steep, Candidates& candidates) {
  constexpr double kReach = 1.25;  // beyond the 1 at which the charts would just meet
  const Knots knots = roots_and_ends(stationarity(p), -kReach, kReach, 4);
  for (std::size_t k = 1; k + 1 < static_cast<std::size_t>(knots.count); ++k) {
    const double t = knots.at[k], size = 1.0 + t * t, angle = degrees(std::atan(t));
    candidates.add(value_at(p, t) / (size * size), steep ? 90.0 - angle : angle);
  }
}

// theory (5.10)
Localisation normalised(const Lame& constants, const ContinuumTangent& tangent) {
  switch (tangent.branch) {
    case Branch::Elastic:
      return {};
    case Branch::Apex:
      return {0.0, 0.0};
    case Branch::Smooth:
      break;
  }
  Localisation minimum = weakest_direction(tangent.moduli);
  minimum.value /= uniaxial_strain_modulus(constants) * constants.mu;
  return minimum;
}

}  // namespace

double acoustic_determinant(const Mat4& moduli, double angle) {
  const double radians = angle * (std::numbers::pi / 180.0);
  const Vec2 n(std::cos(radians), std::sin(radians));
  Mat2 q = Mat2::Zero();
  for (int j = 0; j < 2; ++j)
    for (int l = 0; l < 2; ++l) q += n[j] * n[l] * moduli.block<2, 2>(2 * j, 2 * l);
  return det(q);
}

Localisation weakest_direction(const Mat4& moduli) {
  const Polynomial flat = acoustic_quartic(moduli);
  const Polynomial steep{flat[4], flat[3], flat[2], flat[1], flat[0]};
  Candidates candidates;
  add_chart(flat, false, candidates);
  add_chart(steep, true, candidates);
  candidates.add(flat[0], 0.0);
  const auto found = std::span(candidates.all).first(candidates.count);
  const auto lower = [](const Localisation& a, const Localisation& b) { return a.value < b.value; };
  const double minimum = std::min_element(found.begin(), found.end(), lower)->value;
  // Directions that mirror each other, and all where the determinant is constant, differ by rounding only.
  double size = 0.0;
  for (const double c : flat) size = std::max(size, std::abs(c));
  const auto smaller = [&](const Localisation& a, const Localisation& b) {
    const bool a_low = a.value <= minimum + 1e-13 * size, b_low = b.value <= minimum + 1e-13 * size;
    return a_low != b_low ? a_low : a.angle < b.angle;
  };
  return *std::min_element(found.begin(), found.end(), smaller);
}

Localisation localisation(const FinitePlastic& law, const Mat2& deformation, const PlasticState& state) {
  return normalised(law.constants, law.continuum_tangent(deformation, state));
}

Localisation localisation(const SmallPlastic& law, const Mat2& deformation, const PlasticState& state) {
  return normalised(law.constants, law.continuum_tangent(deformation, state));
}

}  // namespace cleft::constitutive
