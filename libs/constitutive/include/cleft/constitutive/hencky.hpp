/// \file
/// Hencky hyperelasticity: quadratic in the logarithmic principal stretches, plane strain.
///
/// With principal stretches l_1, l_2 (l_3 = 1) and W = lambda/2 (sum ln l_A)^2 + mu sum (ln l_A)^2 the principal
/// Kirchhoff stresses are lambda ln J + 2 mu ln l_A (Liu and Borja 2010, section 5.3). Split F into its conformal part,
/// of size R^(1/2) = (l_1 + l_2)/2, and its anticonformal part, of size Q^(1/2) = (l_1 - l_2)/2; both sizes are
/// quadratic in F:
///
///     4 R = (F_11 + F_22)^2 + (F_21 - F_12)^2,      4 Q = (F_11 - F_22)^2 + (F_21 + F_12)^2,      J = R - Q.
///
/// Then, with r = Q/R and ln(l_1/l_2) = 2 atanh(sqrt r),
///
///     W = (lambda + mu)/2 (ln J)^2 + mu/2 D(r),      D(r) = (2 atanh sqrt r)^2,
///
/// where D is analytic in r also at r = 0: equal stretches are an ordinary point, no eigenvectors are needed, and
/// nothing is lost as the stretches approach each other. At F = I the stress is exactly zero and the tangent exactly
/// that of linear elasticity.
#pragma once

#include "cleft/constitutive/elastic.hpp"
#include "cleft/constitutive/response.hpp"

namespace cleft::constitutive {

struct Hencky {
  Lame constants;

  /// Strain energy per unit reference volume, J/m^3. Needs det F > 0.
  double energy(const Mat2& deformation) const;

  /// Stress and tangent. Needs det F > 0.
  Response respond(const Mat2& deformation) const;
};

/// D(r) = (2 atanh sqrt r)^2 for 0 <= r < 1 with its first and second derivative, all to full relative accuracy.
struct SquaredLogRatio {
  double value, first, second;
};
SquaredLogRatio squared_log_ratio(double r);

}  // namespace cleft::constitutive
