#include "cleft/contact/pair.hpp"

#include <algorithm>
#include <cmath>

namespace cleft::contact {
namespace {

using Row = Eigen::Matrix<double, 1, kPairInputs>;
using Rows = Eigen::Matrix<double, 2, kPairInputs>;

struct Frame {
  Vec2 y, t, n;
  double length;
};

Frame frame(const PairPoints& p, const PairConstants& c) {
  const Vec2 along = p.negative_end - p.negative_start;
  const double length = along.norm();
  const Vec2 t = along / length;
  return {p.negative_start + c.eta * along, t, c.normal_sign * turn_left(t), length};
}

// theory (6.5): length of the share that lies on the near side of the mouth as seen along the positive face, over the
// whole share, before clamping to [0, 1].
double covered(const PairPoints& p, const PairConstants& c, const Frame& f) {
  const double overrun = -c.mouth * (f.y - p.mouth).dot(f.t);
  const double inner = (c.mouth > 0 ? c.share_end - c.eta : c.eta - c.share_begin) * f.length;
  return (inner - overrun) / ((c.share_end - c.share_begin) * f.length);
}

}  // namespace

// theory (6.1), (6.3)
PairState evaluate(const PairPoints& p, const PairConstants& c) {
  const Frame f = frame(p, c);
  const Vec2 e = p.positive_end - p.positive_start;
  PairState s;
  s.stretch_length = f.length;
  s.partner = (f.y - p.positive_start).dot(f.t) / e.dot(f.t);
  s.slope = e.dot(f.n) / e.dot(f.t);
  const Vec2 partner = p.positive_start + s.partner * e;
  s.normal_gap = (partner - f.y).dot(f.n);
  if (c.anchored) s.tangential_gap = (p.anchor - f.y).dot(f.t);
  if (c.mouth != 0) s.ramp = std::clamp(covered(p, c, f), 0.0, 1.0);
  s.traction = traction(c.law, s.normal_gap, s.tangential_gap, c.anchored, c.touch);
  if (s.ramp == 0.0) s.traction = {};
  return s;
}

// theory (7.4) to (7.6)
PairForce force(const PairPoints& p, const PairConstants& c, const PairState& s) {
  const Frame f = frame(p, c);
  const Vec2 e = p.positive_end - p.positive_start;
  const double et = e.dot(f.t);

  // Variations as rows over the twelve inputs.
  Rows dy = Rows::Zero(), d_along = Rows::Zero(), d_partner = Rows::Zero(), d_anchor = Rows::Zero();
  for (int i = 0; i < 2; ++i) {
    dy(i, i) = 1.0 - c.eta;
    dy(i, 2 + i) = c.eta;
    d_along(i, i) = -1.0;
    d_along(i, 2 + i) = 1.0;
    d_partner(i, 4 + i) = 1.0 - s.partner;
    d_partner(i, 6 + i) = s.partner;
    d_anchor(i, 8 + i) = 1.0;
  }
  const Row spin = f.n.transpose() * d_along / f.length;
  const Rows d_gap = d_partner - dy;
  const Row d_xi = -(f.t.transpose() * d_gap + s.normal_gap * spin) / et;
  const Row d_normal_gap = f.n.transpose() * d_gap + e.dot(f.n) * d_xi;

  const double tn = s.traction.normal, tt = s.traction.tangential;
  const Row d_tn = c.law.normal_penalty * d_normal_gap;
  Row d_tt = Row::Zero();
  if (s.traction.status == Status::Stick && c.anchored)
    d_tt = c.law.tangential_penalty * (f.t.transpose() * (d_anchor - dy) + (p.anchor - f.y).dot(f.n) * spin);
  else if (s.traction.status == Status::Slip)
    d_tt = -c.law.friction * std::copysign(1.0, tt) * d_tn;

  Vec2 t0 = tn * f.n + tt * f.t;
  Rows d_t0 = f.n * d_tn + f.t * d_tt + (tt * f.n - tn * f.t) * spin;
  double couple = tt * s.normal_gap;
  Row d_couple = s.normal_gap * d_tt + tt * d_normal_gap;
  const Row d_length = f.t.transpose() * d_along;
  if (s.ramp < 1.0) {
    // covered = (constant share) - overrun / (share width * length), overrun = -mouth (y - x_E) . t
    const Vec2 past = f.y - p.mouth;
    Row d_overrun = f.t.transpose() * dy + past.dot(f.n) * spin;
    for (int i = 0; i < 2; ++i) d_overrun(10 + i) -= f.t(i);
    d_overrun *= -c.mouth;
    const double overrun = -c.mouth * past.dot(f.t);
    const double width = (c.share_end - c.share_begin) * f.length;
    const Row d_ramp = -(d_overrun - (overrun / f.length) * d_length) / width;
    d_t0 = s.ramp * d_t0 + t0 * d_ramp;
    t0 *= s.ramp;
    d_couple = s.ramp * d_couple + couple * d_ramp;
    couple *= s.ramp;
  }

  const std::array<double, 4> weight{-(1.0 - c.eta), -c.eta, 1.0 - s.partner, s.partner};
  PairForce out;
  for (int k = 0; k < 4; ++k) {
    out.force.segment<2>(2 * k) = c.weight * weight[k] * t0;
    out.tangent.middleRows<2>(2 * k) = c.weight * weight[k] * d_t0;
  }
  out.tangent.middleRows<2>(4) -= c.weight * t0 * d_xi;
  out.tangent.middleRows<2>(6) += c.weight * t0 * d_xi;

  const Vec2 pair_of_forces = couple / f.length * f.n;
  const Rows d_pair_of_forces = (f.n * d_couple - couple * f.t * spin - couple / f.length * f.n * d_length) / f.length;
  out.force.segment<2>(0) -= c.weight * pair_of_forces;
  out.force.segment<2>(2) += c.weight * pair_of_forces;
  out.tangent.middleRows<2>(0) -= c.weight * d_pair_of_forces;
  out.tangent.middleRows<2>(2) += c.weight * d_pair_of_forces;
  return out;
}

}  // namespace cleft::contact
