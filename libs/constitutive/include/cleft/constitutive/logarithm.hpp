/// \file
/// The series behind logarithmic strains in the plane, to full relative accuracy also where principal values coincide.
///
/// A symmetric 2 x 2 tensor b with principal values b_1, b_2 has the Mohr circle m (1 +- |w|): m its centre, m w its
/// radius vector. Since ln(b_1/b_2) = 2 atanh|w|, its logarithmic strain (1/2) ln b has the circle
///
///     centre (1/4) ln det b,      radius vector (1/2) A(w.w) w,      A(r) = atanh(sqrt r)/sqrt r,
///
/// where A is analytic at r = 0.
#pragma once

namespace cleft::constitutive {

/// B(r) = (A(r) - 1)/r = 1/3 + r/5 + r^2/7 + ... for 0 <= r < 1, from which A(r) = 1 + r B(r) and
/// A'(r) = (1/(1 - r) - B(r))/2 follow without loss of digits.
double atanh_remainder(double r);

}  // namespace cleft::constitutive
