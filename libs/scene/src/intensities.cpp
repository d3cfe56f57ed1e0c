#include "intensities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "cleft/assembly/stress.hpp"

namespace cleft::scene {
namespace {

using enrichment::FacePiece, enrichment::Intensities, enrichment::PlaneStrain;
using geometry::Side;

PlaneStrain body_of(const assembly::Model& m) {
  const auto& c = m.constants();
  return {c.mu, 0.5 * c.lambda / (c.lambda + c.mu)};
}

// What the faces of a crack transmit, point by point: on the face that carries the point, and opposite to it.
std::vector<FacePiece> tractions(const assembly::LoadStepper& stepper, Index crack) {
  const auto& surfaces = stepper.model().surfaces;
  std::vector<FacePiece> out;
  for (std::size_t p = 0; p < stepper.pairs().size(); ++p) {
    const auto& pair = stepper.pairs()[p];
    const auto& point = surfaces.points[p];
    const auto& face = surfaces.faces[point.face];
    if (face.crack != crack || !contact::presses(pair)) continue;
    const Vec2 along = face.reference_end - face.reference_start, t = along.normalized();
    const auto& traction = pair.state.traction;
    const Vec2 t0 = pair.state.ramp * (traction.normal * face.normal_sign() * turn_left(t) + traction.tangential * t);
    const double part = point.weight / ((point.share_end - point.share_begin) * along.norm());  // 1/2 of both sides'
    const Vec2 start = face.reference_start + point.share_begin * along,
               end = face.reference_start + point.share_end * along;
    out.push_back({start, end, face.side, part * t0});
    out.push_back({start, end, geometry::other(face.side), -part * t0});
  }
  return out;
}

Intensities by_integral(const assembly::LoadStepper& stepper, Index tip) {
  const auto& m = stepper.model();
  const auto& ball = m.cut.tips[tip];
  const VecX& u = stepper.state().displacement;
  const auto state = [&](const enrichment::TipPoint& point) -> enrichment::PointState {
    const Mat2 F = point.deformation(u);
    return {F - Mat2::Identity(), assembly::stress_of(m.material, F).in_plane};
  };
  return enrichment::interaction_integral(ball, tip, m.tip_points, state, tractions(stepper, ball.crack), body_of(m));
}

// The value at 0 of the straight line through (x, y) with least squares.
class Line {
 public:
  void add(double x, double y) {
    n_ += 1.0;
    x_ += x;
    y_ += y;
    xx_ += x * x;
    xy_ += x * y;
  }
  double at_zero() const { return (y_ * xx_ - x_ * xy_) / (n_ * xx_ - x_ * x_); }

 private:
  double n_ = 0.0, x_ = 0.0, y_ = 0.0, xx_ = 0.0, xy_ = 0.0;
};

Intensities by_faces(const assembly::LoadStepper& stepper, Index tip) {
  constexpr double kNearest = 0.05;  // of the radius: nearer the jump is too small to tell
  const auto& m = stepper.model();
  const auto& ball = m.cut.tips[tip];
  const auto body = body_of(m);
  const Vec2 ahead = ball.frame.ahead(), left = turn_left(ahead);
  const Side upper = ball.end == 1 ? Side::Left : Side::Right;  // the face to the left of the crack's continuation
  const VecX& u = stepper.state().displacement;
  Line opening, sliding;
  for (std::size_t s = 0; s < m.cut.segments.size(); ++s) {
    if (m.cut.segments[s].tip != tip) continue;
    const auto& above = m.surfaces.faces[enrichment::face_of(static_cast<Index>(s), upper)];
    const auto& below = m.surfaces.faces[enrichment::face_of(static_cast<Index>(s), geometry::other(upper))];
    const Vec2 jump = above.start.displacement(u) - below.start.displacement(u);
    const double r = (above.reference_start - ball.frame.tip()).norm();
    if (r < kNearest * ball.radius || r > m.unknowns.plateau * ball.radius) continue;
    const double factor = body.shear_modulus / (body.kappa() + 1.0) * std::sqrt(2.0 * std::numbers::pi / r);
    opening.add(r, factor * jump.dot(left));
    sliding.add(r, factor * jump.dot(ahead));
  }
  return {opening.at_zero(), sliding.at_zero()};
}

}  // namespace

std::vector<std::string> intensity_columns(const std::string& crack) {
  std::vector<std::string> out;
  for (const char* end : {"start", "end"})
    for (const char* what : {"k1", "k2", "k1_faces", "k2_faces"})
      out.push_back(fmt::format("{}_{}_{}", what, crack, end));
  return out;
}

std::vector<double> intensities_of(const assembly::LoadStepper& stepper, Index crack) {
  const auto& tips = stepper.model().cut.tips;
  std::vector<double> out(8, std::numeric_limits<double>::quiet_NaN());
  for (Index tip = 0; tip < static_cast<Index>(tips.size()); ++tip) {
    if (tips[tip].crack != crack) continue;
    const Intensities a = by_integral(stepper, tip), b = by_faces(stepper, tip);
    std::ranges::copy(std::array{a.K_I, a.K_II, b.K_I, b.K_II}, out.begin() + 4 * tips[tip].end);
  }
  return out;
}

}  // namespace cleft::scene
