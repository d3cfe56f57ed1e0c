/// \file
/// What a finite-strain material answers to a deformation gradient.
#pragma once

#include "cleft/support/types.hpp"

namespace cleft::constitutive {

/// First Piola-Kirchhoff stress and its derivative, plane strain. Stress positive in tension.
struct Response {
  Mat2 piola;    ///< P = dW/dF, Pa
  Mat4 tangent;  ///< dP/dF, Pa; row i + 2 J, column k + 2 L holds dP_iJ / dF_kL
};

/// Cauchy stress in the plane from P and F: sigma = P F^T / J.
inline Mat2 cauchy(const Mat2& piola, const Mat2& deformation) {
  return piola * deformation.transpose() / det(deformation);
}

/// Cofactor matrix as a linear map on (F_11, F_21, F_12, F_22): vec(cof F) = cofactor_map() vec(F). In the plane the
/// cofactor is linear in F, so this is also its derivative.
inline Mat4 cofactor_map() {
  Mat4 m = Mat4::Zero();
  m(0, 3) = m(3, 0) = 1.0;
  m(1, 2) = m(2, 1) = -1.0;
  return m;
}

}  // namespace cleft::constitutive
