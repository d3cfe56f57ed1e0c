#include <cmath>
#include <numbers>

#include "fields.hpp"

namespace cleft::problem {
namespace {

// Angle against the direction ahead of the tip, on the faces +pi to the left and -pi to the right; beyond them where
// the side that is asked for is the other one's.
double angle_of(const Vec2& local, geometry::MaybeSide side) {
  const double angle = std::atan2(local.y(), local.x());
  if (!side || local.x() >= 0.0) return angle;
  if (*side == geometry::Side::Left) return angle > 0.0 ? angle : angle + 2.0 * std::numbers::pi;
  return angle > 0.0 ? angle - 2.0 * std::numbers::pi : angle;
}

Field near_tip(const FieldSpec& spec, const constitutive::Lame& c, const Vec2& origin, bool opening) {
  const Parameters p(spec, {{"tip_x", 0.0}, {"tip_y", 0.0}, {"angle", 0.0}, {"K", 1e6}});
  const Frame frame(p.place("tip_x", "tip_y", origin), p("angle"));
  const double poisson = c.lambda / (2.0 * (c.lambda + c.mu));
  const double kappa = 3.0 - 4.0 * poisson;
  const double factor = p("K") / (2.0 * c.mu);
  return [=](const Vec2& X, geometry::MaybeSide side) -> Vec2 {
    const Vec2 local = frame.local(X);
    const double half = 0.5 * angle_of(local, side);
    const double size = factor * std::sqrt(local.norm() / (2.0 * std::numbers::pi));
    const double s = std::sin(half), co = std::cos(half);
    const Vec2 u = opening ? Vec2(co * (kappa - 1.0 + 2.0 * s * s), s * (kappa + 1.0 - 2.0 * co * co))
                           : Vec2(s * (kappa + 1.0 + 2.0 * co * co), -co * (kappa - 1.0 - 2.0 * s * s));
    return size * (frame.turn * u);
  };
}

}  // namespace

Field mode_one(const FieldSpec& spec, const constitutive::Lame& c, const Vec2& origin) {
  return near_tip(spec, c, origin, true);
}
Field mode_two(const FieldSpec& spec, const constitutive::Lame& c, const Vec2& origin) {
  return near_tip(spec, c, origin, false);
}

}  // namespace cleft::problem
