#include "cleft/constitutive/hencky.hpp"

#include <cmath>

#include "cleft/constitutive/logarithm.hpp"

namespace cleft::constitutive {
namespace {

using Vec4 = Eigen::Vector4d;

// The squared sizes of the two parts of F, and the halved gradients, linear in F.
struct Parts {
  double conformal, anticonformal;                  // R, Q
  Vec4 conformal_gradient, anticonformal_gradient;  // dR/dF, dQ/dF
};

// theory (4.2)
Parts split(const Mat2& F) {
  const double p1 = 0.5 * (F(0, 0) + F(1, 1)), p2 = 0.5 * (F(1, 0) - F(0, 1));
  const double q1 = 0.5 * (F(0, 0) - F(1, 1)), q2 = 0.5 * (F(1, 0) + F(0, 1));
  return {p1 * p1 + p2 * p2, q1 * q1 + q2 * q2, Vec4(p1, p2, -p2, p1), Vec4(q1, q2, q2, -q1)};
}

}  // namespace

SquaredLogRatio squared_log_ratio(double r) {
  // D = 4 r A^2 with A = atanh(sqrt r)/sqrt r, and dD/dr = 4 A/(1 - r)
  const double remainder = atanh_remainder(r);
  const double c = 1.0 / (1.0 - r);
  const double A = 1.0 + r * remainder, slope = 0.5 * (c - remainder);
  return {4.0 * r * A * A, 4.0 * A * c, 4.0 * c * (slope + A * c)};
}

// theory (4.3)
double Hencky::energy(const Mat2& deformation) const {
  const Parts s = split(deformation);
  const double log_j = std::log(s.conformal - s.anticonformal);
  return 0.5 * (constants.lambda + constants.mu) * log_j * log_j +
         0.5 * constants.mu * squared_log_ratio(s.anticonformal / s.conformal).value;
}

// theory (4.4), (4.5)
Response Hencky::respond(const Mat2& deformation) const {
  const Parts s = split(deformation);
  const double J = s.conformal - s.anticonformal;
  const double log_j = std::log(J);
  const double r = s.anticonformal / s.conformal;
  const SquaredLogRatio d = squared_log_ratio(r);
  const double bulk = constants.lambda + constants.mu;
  const double half_mu = 0.5 * constants.mu;
  const Vec4 inverse_transposed = (s.conformal_gradient - s.anticonformal_gradient) / J;
  const Vec4 dr = (s.anticonformal_gradient - r * s.conformal_gradient) / s.conformal;

  Response out;
  const Vec4 piola = bulk * log_j * inverse_transposed + half_mu * d.first * dr;
  out.piola << piola(0), piola(2), piola(1), piola(3);

  // Second derivatives: R and Q are quadratic forms with constant Hessians (I + C)/2 and (I - C)/2, C the cofactor map.
  const Mat4 cof = cofactor_map();
  const Mat4 one = Mat4::Identity();
  const double on_one = half_mu * d.first * 0.5 * (1.0 - r) / s.conformal;
  const double on_cof = bulk * log_j / J - half_mu * d.first * 0.5 * (1.0 + r) / s.conformal;
  const Mat4 mixed = dr * s.conformal_gradient.transpose() * (half_mu * d.first / s.conformal);
  out.tangent = on_one * one + on_cof * cof +
                bulk * (1.0 - log_j) * inverse_transposed * inverse_transposed.transpose() +
                half_mu * d.second * dr * dr.transpose() - mixed - mixed.transpose();
  return out;
}

}  // namespace cleft::constitutive
