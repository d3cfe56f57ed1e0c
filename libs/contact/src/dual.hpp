// Numbers that carry their derivatives with regard to a few inputs.
#pragma once

#include <array>
#include <cmath>

namespace cleft::contact {

template <int inputs>
struct Dual {
  double value = 0.0;
  std::array<double, inputs> by{};

  Dual() = default;
  Dual(double v) : value(v) {}  // NOLINT: a constant is such a number
  static Dual input(double v, int number) {
    Dual out(v);
    out.by[number] = 1.0;
    return out;
  }
};

template <int n>
Dual<n> operator+(Dual<n> a, const Dual<n>& b) {
  a.value += b.value;
  for (int k = 0; k < n; ++k) a.by[k] += b.by[k];
  return a;
}

template <int n>
Dual<n> operator-(Dual<n> a, const Dual<n>& b) {
  a.value -= b.value;
  for (int k = 0; k < n; ++k) a.by[k] -= b.by[k];
  return a;
}

template <int n>
Dual<n> operator*(const Dual<n>& a, const Dual<n>& b) {
  Dual<n> out(a.value * b.value);
  for (int k = 0; k < n; ++k) out.by[k] = a.by[k] * b.value + a.value * b.by[k];
  return out;
}

template <int n>
Dual<n> operator/(const Dual<n>& a, const Dual<n>& b) {
  const double inverse = 1.0 / b.value;
  Dual<n> out(a.value * inverse);
  for (int k = 0; k < n; ++k) out.by[k] = (a.by[k] - out.value * b.by[k]) * inverse;
  return out;
}

template <int n>
Dual<n> operator+(Dual<n> a, double b) {
  a.value += b;
  return a;
}

template <int n>
Dual<n> operator-(double a, const Dual<n>& b) {
  Dual<n> out(a - b.value);
  for (int k = 0; k < n; ++k) out.by[k] = -b.by[k];
  return out;
}

template <int n>
Dual<n> operator-(const Dual<n>& a, double b) {
  return a + -b;
}

template <int n>
Dual<n> operator*(double a, Dual<n> b) {
  b.value *= a;
  for (int k = 0; k < n; ++k) b.by[k] *= a;
  return b;
}

template <int n>
Dual<n> sqrt(const Dual<n>& a) {
  Dual<n> out(std::sqrt(a.value));
  for (int k = 0; k < n; ++k) out.by[k] = 0.5 * a.by[k] / out.value;
  return out;
}

}  // namespace cleft::contact
