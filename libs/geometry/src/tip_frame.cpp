#include <cmath>
#include <limits>
#include <numbers>

#include "cleft/geometry/tip.hpp"

namespace cleft::geometry {

TipFrame::TipFrame(const std::vector<Vec2>& points, Side positive) : tip_(points.front()), positive_(positive) {
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    const Vec2 along = (points[k + 1] - points[k]).normalized();
    const Vec2 from_tip = points[k] - tip_;
    arms_.push_back({from_tip.norm(), along, cross(along, from_tip)});
  }
}

double TipFrame::straight_until() const {
  return arms_.size() > 1 ? arms_[1].r : std::numeric_limits<double>::infinity();
}

TipPolar TipFrame::at(const Vec2& point, MaybeSide side) const {
  TipPolar polar;
  const Vec2 from_tip = point - tip_;
  polar.r = from_tip.norm();
  if (polar.r == 0.0) return polar;
  const Arm* arm = &arms_.front();
  for (const Arm& next : arms_) {
    if (next.r <= polar.r) arm = &next;
  }
  // The crack crosses this circle at tip + forth along + offset turn_left(along).
  const double forth = std::sqrt(polar.r * polar.r - arm->offset * arm->offset);
  const Vec2 back = -(forth * arm->along + arm->offset * turn_left(arm->along));
  polar.angle = std::atan2(cross(back, from_tip), back.dot(from_tip));
  polar.r_gradient = from_tip / polar.r;
  // d alpha / dr = - offset / (r forth)
  polar.angle_gradient = turn_left(polar.r_gradient) / polar.r + arm->offset / (polar.r * forth) * polar.r_gradient;
  if (side) {
    const double sign = *side == positive_ ? 1.0 : -1.0;
    if (sign * polar.angle < -0.5 * std::numbers::pi) polar.angle += sign * 2.0 * std::numbers::pi;
  }
  return polar;
}

}  // namespace cleft::geometry
