/// \file
/// Symmetric second-order tensors of plane strain: stresses and strains with their out-of-plane component.
#pragma once

#include <cmath>

#include "cleft/support/types.hpp"

namespace cleft::constitutive {

/// A symmetric tensor T with T_13 = T_23 = 0, stored as its Mohr circle: the in-plane part is
///
///     centre I + [ radius_0   radius_1 ]
///                [ radius_1  -radius_0 ].
///
/// The in-plane principal values are centre +- |radius|. An isotropic function scales `radius` and so needs neither
/// eigenvectors nor a decision of what to do where they coincide.
struct PlaneTensor {
  double centre = 0.0;         ///< (T_11 + T_22)/2
  Vec2 radius = Vec2::Zero();  ///< ((T_11 - T_22)/2, T_12)
  double normal = 0.0;         ///< T_33
};

/// From the components of a symmetric tensor.
inline PlaneTensor plane_tensor(double t11, double t22, double t12, double t33) {
  return {0.5 * (t11 + t22), {0.5 * (t11 - t22), t12}, t33};
}

inline PlaneTensor operator*(double factor, const PlaneTensor& a) {
  return {factor * a.centre, factor * a.radius, factor * a.normal};
}

inline double trace(const PlaneTensor& a) { return 2.0 * a.centre + a.normal; }

/// a : b
inline double contract(const PlaneTensor& a, const PlaneTensor& b) {
  return 2.0 * (a.centre * b.centre + a.radius.dot(b.radius)) + a.normal * b.normal;
}

/// a - tr(a)/3 1
inline PlaneTensor deviator(const PlaneTensor& a) {
  const double third = (a.centre - a.normal) / 3.0;
  return {third, a.radius, -2.0 * third};
}

/// The deviator over its Frobenius norm; zero where there is none.
inline PlaneTensor unit_deviator(const PlaneTensor& a) {
  const PlaneTensor s = deviator(a);
  const double size = std::sqrt(contract(s, s));
  return size > 0.0 ? (1.0 / size) * s : s;
}

/// a + factor 1
inline PlaneTensor plus_identity(const PlaneTensor& a, double factor) {
  return {a.centre + factor, a.radius, a.normal + factor};
}

/// The in-plane components.
inline Mat2 in_plane(const PlaneTensor& a) {
  Mat2 m;
  m << a.centre + a.radius[0], a.radius[1], a.radius[1], a.centre - a.radius[0];
  return m;
}

}  // namespace cleft::constitutive
