#include "cleft/enrichment/sif.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cleft::enrichment {

namespace {

const double kRootOfTwoPi = std::sqrt(2.0 * std::numbers::pi);

// q is constant within this part of the radius; it needs a few elements to fall.
constexpr double kWeightPlateau = 0.2;

// Columns: straight ahead, and left of that.
Mat2 axes(const geometry::TipBall& ball) {
  Mat2 Q;
  Q << ball.frame.ahead(), turn_left(ball.frame.ahead());
  return Q;
}

Vec2 unit_displacement(Mode mode, const geometry::TipPolar& at, const PlaneStrain& body) {
  const Branches f = branches(at);
  const auto c = unit_amplitudes(mode, body);
  Vec2 u = Vec2::Zero();
  for (int a = 0; a < kBranches; ++a) u += f.value[a] * c[a];
  return u;
}

}  // namespace

Mat2 PlaneStrain::stress(const Mat2& gradient) const {
  const double lambda = 2.0 * shear_modulus * poisson_ratio / (1.0 - 2.0 * poisson_ratio);
  return lambda * gradient.trace() * Mat2::Identity() + shear_modulus * (gradient + gradient.transpose());
}

std::array<Vec2, kBranches> unit_amplitudes(Mode mode, const PlaneStrain& body) {
  const double k = 1.0 / (2.0 * body.shear_modulus * kRootOfTwoPi), kappa = body.kappa();
  if (mode == Mode::I) return {k * Vec2(kappa - 1, 0), k * Vec2(0, kappa + 1), k * Vec2(1, 0), k * Vec2(0, -1)};
  return {k * Vec2(0, 1 - kappa), k * Vec2(kappa + 1, 0), k * Vec2(0, 1), k * Vec2(1, 0)};
}

ModeField unit_field(Mode mode, double r, double angle, const PlaneStrain& body) {
  const Vec2 outward(std::cos(angle), std::sin(angle));
  const Branches f = branches({r, angle, outward, turn_left(outward) / r});
  const auto c = unit_amplitudes(mode, body);
  ModeField field{Vec2::Zero(), Mat2::Zero(), Mat2::Zero()};
  for (int a = 0; a < kBranches; ++a) {
    field.displacement += f.value[a] * c[a];
    field.gradient += c[a] * f.gradient[a].transpose();
  }
  field.stress = body.stress(field.gradient);
  return field;
}

Intensities intensities_of_amplitudes(const geometry::TipBall& ball, const std::array<Vec2, kBranches>& amplitudes,
                                      const PlaneStrain& body) {
  const Vec2 second =
      2.0 * body.shear_modulus * kRootOfTwoPi / (body.kappa() + 1.0) * (axes(ball).transpose() * amplitudes[1]);
  return {second.y(), second.x()};
}

// theory (10.5)
Intensities interaction_integral(const geometry::TipBall& ball, Index tip, const std::vector<TipPoint>& points,
                                 const std::function<PointState(const TipPoint&)>& state,
                                 const std::vector<FacePiece>& faces, const PlaneStrain& body) {
  const Mat2 Q = axes(ball);
  const double radius = std::min(ball.radius, ball.frame.straight_until());
  const auto weight = [&](double r) { return cutoff(r, kWeightPlateau * radius, radius); };
  constexpr std::array<Mode, 2> kModes{Mode::I, Mode::II};
  std::array<double, 2> integral{};
  for (const TipPoint& point : points) {
    if (point.tip != tip) continue;
    const geometry::TipPolar at = ball.frame.at(point.reference, point.side);
    const Cutoff q = weight(at.r);
    if (q.slope == 0.0) continue;
    const Vec2 slope = q.slope * (Q.transpose() * at.r_gradient);
    const PointState turned = state(point);
    const Mat2 H = Q.transpose() * turned.gradient * Q, s = Q.transpose() * turned.stress * Q;
    for (const int m : {0, 1}) {
      const ModeField mode = unit_field(kModes[m], at.r, at.angle, body);
      const Vec2 flux = s.transpose() * mode.gradient.col(0) + mode.stress.transpose() * H.col(0) -
                        s.cwiseProduct(mode.gradient).sum() * Vec2::UnitX();
      integral[m] += point.weight * flux.dot(slope);
    }
  }
  // Along a straight face v_i,1 ds is an increment of v_i: no quadrature of its singularity is needed.
  for (const FacePiece& piece : faces) {
    const double q = weight((0.5 * (piece.start + piece.end) - ball.frame.tip()).norm()).value;
    if (q == 0.0) continue;
    const bool forward = Q.col(0).dot(piece.end - piece.start) > 0.0;
    const geometry::TipPolar back = ball.frame.at(forward ? piece.start : piece.end, piece.side);
    const geometry::TipPolar front = ball.frame.at(forward ? piece.end : piece.start, piece.side);
    const Vec2 traction = Q.transpose() * piece.traction;
    for (const int m : {0, 1}) {
      const Vec2 increment = unit_displacement(kModes[m], front, body) - unit_displacement(kModes[m], back, body);
      integral[m] -= q * traction.dot(increment);
    }
  }
  // E' = E / (1 - nu^2) = 2 mu / (1 - nu)
  const double half_modulus = body.shear_modulus / (1.0 - body.poisson_ratio);
  return {half_modulus * integral[0], half_modulus * integral[1]};
}

}  // namespace cleft::enrichment
