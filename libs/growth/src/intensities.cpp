#include "cleft/growth/intensities.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "cleft/assembly/stress.hpp"
#include "cleft/problem/tip_reach.hpp"

namespace cleft::growth {
namespace {

using enrichment::FacePiece, enrichment::Intensities, enrichment::PlaneStrain;
using geometry::Side;

// Any material point in the ball of a tip: they are all of one material (fill_with_materials).
Index point_near(const assembly::Model& m, Index tip) {
  const auto at = std::ranges::find(m.tip_points, tip, &enrichment::TipPoint::tip);
  return static_cast<Index>(m.cells.size()) + static_cast<Index>(at - m.tip_points.begin());
}

PlaneStrain body_of(const assembly::Model& m, Index tip) {
  const auto& c = m.constants(point_near(m, tip));
  return {c.mu, 0.5 * c.lambda / (c.lambda + c.mu)};
}

// How the body around a tip is turned. What is measured along R and less the spin is that of the body before the turn.
struct Turn {
  Mat2 R = Mat2::Identity();
  Mat2 spin = Mat2::Zero();  // of small strain, where turns add up instead

  // Of a displacement gradient.
  Mat2 gradient(const Mat2& H) const { return R.transpose() * H + (R.transpose() - Mat2::Identity()) - spin; }
};

// The rotation of the polar decomposition of the mean deformation gradient within the reach of a tip, or at small
// strain the skew part of its displacement gradient: the integral does not see that, but its quadrature does, and a
// body may turn much more than it strains.
Turn turn_around(const assembly::Equilibrium& body, Index tip) {
  const auto& m = body.model;
  const auto& ball = m.cut.tips[tip];
  Mat2 sum = Mat2::Zero();
  double area = 0.0;
  for (const auto& point : m.tip_points) {
    if (point.tip != tip || (point.reference - ball.frame.tip()).norm() >= ball.reach) continue;
    sum += point.weight * assembly::displacement_gradient(point, body.displacement);
    area += point.weight;
  }
  Turn out;
  if (m.is_small_strain()) {
    out.spin = 0.5 * (sum - sum.transpose()) / area;
  } else {
    const Vec2 first = Vec2(sum(0, 0) + sum(1, 1) + 2.0 * area, sum(1, 0) - sum(0, 1)).normalized();
    out.R << first, turn_left(first);
  }
  return out;
}

// The tangent of a face as contact sees it.
Vec2 tangent(const assembly::Equilibrium& body, const enrichment::Face& face) {
  const Vec2 along = face.reference_end - face.reference_start;
  if (body.model.surfaces.undeformed) return along.normalized();
  const VecX& u = body.displacement;
  return (along + face.end.displacement(u) - face.start.displacement(u)).normalized();
}

// What the faces of a crack transmit, point by point: on the face that carries the point, and opposite to it; turned
// back by R.
std::vector<FacePiece> tractions(const assembly::Equilibrium& body, Index crack, const Mat2& R) {
  const auto& surfaces = body.model.surfaces;
  std::vector<FacePiece> out;
  for (std::size_t p = 0; p < body.pairs.size(); ++p) {
    const auto& pair = body.pairs[p];
    const auto& point = surfaces.points[p];
    const auto& face = surfaces.faces[point.face];
    if (face.crack != crack || !contact::presses(pair)) continue;
    const Vec2 along = face.reference_end - face.reference_start, t = R.transpose() * tangent(body, face);
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

// The straight line through (x, y) with least squares.
class Line {
 public:
  void add(double x, double y, double weight = 1.0) {
    n_ += weight;
    x_ += weight * x;
    y_ += weight * y;
    xx_ += weight * x * x;
    xy_ += weight * x * y;
  }
  double operator()(double x) const { return (y_ * xx_ - x_ * xy_ + (n_ * xy_ - x_ * y_) * x) / (n_ * xx_ - x_ * x_); }

 private:
  double n_ = 0.0, x_ = 0.0, y_ = 0.0, xx_ = 0.0, xy_ = 0.0;
};

double distance(const FacePiece& piece, const geometry::TipBall& ball) {
  return (0.5 * (piece.start + piece.end) - ball.frame.tip()).norm();
}

// The part of the faces that tells what acts at the tip: straight, and in the ball, of which a part may be no body.
double straight_reach(const geometry::TipBall& ball) { return std::min(ball.radius, ball.frame.straight_until()); }

bool is_closed(const assembly::Equilibrium& body, const geometry::TipBall& ball) {
  const auto& surfaces = body.model.surfaces;
  bool any = false;
  for (std::size_t p = 0; p < body.pairs.size(); ++p) {
    const auto& point = surfaces.points[p];
    const auto& face = surfaces.faces[point.face];
    const Vec2 X = (1.0 - point.eta) * face.reference_start + point.eta * face.reference_end;
    if (face.crack != ball.crack || (X - ball.frame.tip()).norm() > straight_reach(ball)) continue;
    any = true;
    if (!contact::presses(body.pairs[p])) return false;
  }
  return any;
}

// At the tip of closed faces the pressure of the penalty is wrong: soft springs lose it within an element, stiff ones
// let it oscillate, and the integral weighs it by r^(-1/2). What acts farther out is continued to the tip: on the
// closed crack of the verification (h = a / 43, springs at 10 E/h) K_II is then off by 0.02 % instead of 3 %.
void smooth(const geometry::TipBall& ball, std::vector<FacePiece>& pieces) {
  constexpr double kWrong = 0.2;  // of the straight part
  std::array<Line, 2> fit;
  const auto sign = [](const FacePiece& piece) { return piece.side == Side::Left ? 1.0 : -1.0; };
  for (const auto& piece : pieces) {
    const double r = distance(piece, ball);
    if (r < kWrong * straight_reach(ball) || r > straight_reach(ball)) continue;
    for (int i = 0; i < 2; ++i) fit[i].add(r, sign(piece) * piece.traction[i], (piece.end - piece.start).norm());
  }
  for (auto& piece : pieces) {
    const double r = distance(piece, ball);
    piece.traction = sign(piece) * Vec2(fit[0](r), fit[1](r));
  }
}

Vec2 body_force(const assembly::Equilibrium& body) {
  return body.model.body_force ? body.model.body_force(body.load) : Vec2::Zero();
}

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

}  // namespace

Intensities intensities_by_integral(const assembly::Equilibrium& body, Index tip) {
  const auto& m = body.model;
  if (problem::elements_within_reach(m, tip) < problem::kLeastReach) return {kUnknown, kUnknown};
  const auto& ball = m.cut.tips[tip];
  const Turn turn = turn_around(body, tip);
  const Mat2& R = turn.R;
  const auto& material = m.material(point_near(m, tip));
  const auto state = [&](const enrichment::TipPoint& point) -> enrichment::PointState {
    const Mat2 H = assembly::displacement_gradient(point, body.displacement);
    return {turn.gradient(H), R.transpose() * assembly::respond_from_rest(material, H).piola};
  };
  auto pieces = tractions(body, ball.crack, R);
  if (is_closed(body, ball)) smooth(ball, pieces);
  return enrichment::interaction_integral(ball, tip, m.tip_points, state,
                                          {std::move(pieces), R.transpose() * body_force(body)}, body_of(m, tip));
}

// theory (10.6)
Intensities intensities_by_faces(const assembly::Equilibrium& body, Index tip) {
  constexpr double kNearest = 0.05;  // of the radius: nearer the jump is too small to tell
  constexpr double kBlunt = 2.0;     // blunt functions: nearer the jump is not that of the singular field
  const auto& m = body.model;
  if (problem::elements_within_reach(m, tip) < problem::kLeastReach) return {kUnknown, kUnknown};
  const auto& ball = m.cut.tips[tip];
  const auto solid = body_of(m, tip);
  const Vec2 ahead = turn_around(body, tip).R * ball.frame.ahead(), left = turn_left(ahead);
  const Side upper = ball.end == 1 ? Side::Left : Side::Right;  // the face to the left of the crack's continuation
  const VecX& u = body.displacement;
  const double nearest = std::max(kNearest * ball.radius, kBlunt * enrichment::blunting_at(m.mesh, m.unknowns, ball));
  const double farthest = std::min(m.unknowns.plateau * ball.radius, ball.reach);
  Line opening, sliding;
  int points = 0;
  for (std::size_t s = 0; s < m.cut.segments.size(); ++s) {
    if (m.cut.segments[s].tip != tip) continue;
    const auto& above = m.surfaces.faces[enrichment::face_of(static_cast<Index>(s), upper)];
    const auto& below = m.surfaces.faces[enrichment::face_of(static_cast<Index>(s), geometry::other(upper))];
    const Vec2 jump = above.start.displacement(u) - below.start.displacement(u);
    const double r = (above.reference_start - ball.frame.tip()).norm();
    if (r < nearest || r > farthest) continue;
    const double factor = solid.shear_modulus / (solid.kappa() + 1.0) * std::sqrt(2.0 * std::numbers::pi / r);
    opening.add(r, factor * jump.dot(left));
    sliding.add(r, factor * jump.dot(ahead));
    ++points;
  }
  if (points < 2) return {kUnknown, kUnknown};
  return {opening(0.0), sliding(0.0)};
}

}  // namespace cleft::growth
