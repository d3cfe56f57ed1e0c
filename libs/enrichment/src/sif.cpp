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

constexpr std::array<Mode, 2> kModes{Mode::I, Mode::II};

// s_ij v_i,1 + z_ij u_i,1 - s_mn v_m,n d_1j
Vec2 flux(const PointState& here, const ModeField& mode) {
  return here.stress.transpose() * mode.gradient.col(0) + mode.stress.transpose() * here.gradient.col(0) -
         here.stress.cwiseProduct(mode.gradient).sum() * Vec2::UnitX();
}

// What the integral of a tip needs to know of the tip.
struct Neighbourhood {
  const geometry::TipBall& ball;
  const PlaneStrain& body;
  Mat2 axes;

  Cutoff weight(double r) const { return cutoff(r, kWeightPlateau * ball.reach, ball.reach); }

  PointState seen(const PointState& state) const {
    return {axes.transpose() * state.gradient * axes, axes.transpose() * state.stress * axes};
  }

  // int t_i v_i,1 q ds over a piece. Along a straight face v_i,1 ds is an increment of v_i: no quadrature of its
  // singularity is needed.
  double work(const FacePiece& piece, Mode mode) const {
    const double q = weight((0.5 * (piece.start + piece.end) - ball.frame.tip()).norm()).value;
    if (q == 0.0) return 0.0;
    const bool forward = axes.col(0).dot(piece.end - piece.start) > 0.0;
    const auto at = [&](const Vec2& point) { return unit_displacement(mode, ball.frame.at(point, piece.side), body); };
    const Vec2 increment = at(forward ? piece.end : piece.start) - at(forward ? piece.start : piece.end);
    return q * (axes.transpose() * piece.traction).dot(increment);
  }
};

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
                                 const std::function<PointState(const TipPoint&)>& state, const TipLoads& loads,
                                 const PlaneStrain& body) {
  const Neighbourhood around{ball, body, axes(ball)};
  const Vec2 force = around.axes.transpose() * loads.body_force;
  std::array<double, 2> integral{};
  for (const TipPoint& point : points) {
    if (point.tip != tip) continue;
    const geometry::TipPolar at = ball.frame.at(point.reference, point.side);
    const Cutoff q = around.weight(at.r);
    if (q.slope == 0.0 && (q.value == 0.0 || force.isZero(0.0))) continue;
    const Vec2 slope = q.slope * (around.axes.transpose() * at.r_gradient);
    const PointState here = around.seen(state(point));
    for (const int m : {0, 1}) {
      const ModeField mode = unit_field(kModes[m], at.r, at.angle, body);
      integral[m] += point.weight * (flux(here, mode).dot(slope) - q.value * force.dot(mode.gradient.col(0)));
    }
  }
  for (const FacePiece& piece : loads.faces)
    for (const int m : {0, 1}) integral[m] -= around.work(piece, kModes[m]);
  // E' = E / (1 - nu^2) = 2 mu / (1 - nu)
  const double half_modulus = body.shear_modulus / (1.0 - body.poisson_ratio);
  return {half_modulus * integral[0], half_modulus * integral[1]};
}

}  // namespace cleft::enrichment
