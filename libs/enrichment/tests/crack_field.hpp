/// \file
/// The exact field around the tip of a straight crack in an infinite elastic plane.
#pragma once

#include <cmath>
#include <numbers>

#include "cleft/geometry/crack.hpp"

namespace cleft::enrichment::test {

/// Plane strain; the shear modulus is 1.
struct Elastic {
  double poisson = 0.3;
  double lambda() const { return 2.0 * poisson / (1.0 - 2.0 * poisson); }
  double kappa() const { return 3.0 - 4.0 * poisson; }
  Mat2 stress(const Mat2& gradient) const {
    return lambda() * gradient.trace() * Mat2::Identity() + gradient + gradient.transpose();
  }
};

/// Modes I and II at once (Williams 1957), a tip at `tip` and the crack behind it, seen along `direction`; a uniform
/// displacement gradient, which knows no crack, may be added.
struct CrackField {
  Vec2 tip;
  double direction = 0.0;  // radians
  double K_I = 1.0, K_II = 0.0;
  Elastic elastic;
  Mat2 uniform = Mat2::Zero();

  Mat2 turn() const {
    Mat2 Q;
    Q << std::cos(direction), -std::sin(direction), std::sin(direction), std::cos(direction);
    return Q;
  }

  /// Left is the side of the crack as it runs towards the tip.
  Vec2 displacement(const Vec2& point, geometry::MaybeSide side) const {
    const auto [r, t] = polar(point, side);
    const double k = std::sqrt(r / (2.0 * std::numbers::pi)) / 2.0, c = std::cos(0.5 * t), s = std::sin(0.5 * t);
    const double kappa = elastic.kappa();
    const Vec2 opening(c * (kappa - 1.0 + 2.0 * s * s), s * (kappa + 1.0 - 2.0 * c * c));
    const Vec2 sliding(s * (kappa + 1.0 + 2.0 * c * c), -c * (kappa - 1.0 - 2.0 * s * s));
    return turn() * (k * (K_I * opening + K_II * sliding)) + uniform * (point - tip);
  }

  /// From the well-known stresses, which the displacement above has not been used for; the rotation from its curl.
  Mat2 gradient(const Vec2& point, geometry::MaybeSide side) const {
    const auto [r, t] = polar(point, side);
    const double k = 1.0 / std::sqrt(2.0 * std::numbers::pi * r);
    const double c = std::cos(0.5 * t), s = std::sin(0.5 * t), c3 = std::cos(1.5 * t), s3 = std::sin(1.5 * t);
    Mat2 one, two;
    one << c * (1 - s * s3), s * c * c3, s * c * c3, c * (1 + s * s3);
    two << -s * (2 + c * c3), c * (1 - s * s3), c * (1 - s * s3), s * c * c3;
    const Mat2 stress = k * (K_I * one + K_II * two);
    const Mat2 strain = 0.5 * (stress - elastic.poisson * stress.trace() * Mat2::Identity());
    const double rotation = 0.25 * (elastic.kappa() + 1.0) * k * (K_I * s - K_II * -c);
    Mat2 spin;
    spin << 0.0, rotation, -rotation, 0.0;
    return turn() * (strain + spin) * turn().transpose() + uniform;
  }

 private:
  std::pair<double, double> polar(const Vec2& point, geometry::MaybeSide side) const {
    const Vec2 x = turn().transpose() * (point - tip);
    double t = std::atan2(x.y(), x.x());
    if (side == geometry::Side::Left && t < -0.5 * std::numbers::pi) t += 2.0 * std::numbers::pi;
    if (side == geometry::Side::Right && t > 0.5 * std::numbers::pi) t -= 2.0 * std::numbers::pi;
    return {x.norm(), t};
  }
};

}  // namespace cleft::enrichment::test
