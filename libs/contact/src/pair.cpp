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

// The variation of a weighted sum of the six points along a direction.
Row along(const Vec2& direction, const std::array<double, kPairInputs / 2>& weight) {
  Row out;
  for (int k = 0; k < kPairInputs / 2; ++k) out.segment<2>(2 * k) = weight[k] * direction.transpose();
  return out;
}

// Variations as rows over the twelve inputs.
struct Variations {
  Row spin, length, xi, normal_gap;
};

Variations vary(const PairPoints& p, const PairConstants& c, const Frame& f, const PairState& s) {
  const Vec2 e = p.positive_end - p.positive_start;
  const std::array<double, 6> gap{-(1.0 - c.eta), -c.eta, 1.0 - s.partner, s.partner, 0.0, 0.0};
  Variations d;
  d.spin = along(f.n, {-1.0, 1.0, 0.0, 0.0, 0.0, 0.0}) / f.length;
  d.length = along(f.t, {-1.0, 1.0, 0.0, 0.0, 0.0, 0.0});
  d.xi = -(along(f.t, gap) + s.normal_gap * d.spin) / e.dot(f.t);
  d.normal_gap = along(f.n, gap) + e.dot(f.n) * d.xi;
  return d;
}

// What acts at the point, and the opposite of it at the partner: traction in the plane (Pa) and couple (Pa m).
struct Load {
  Vec2 traction;
  Rows d_traction;
  double couple;
  Row d_couple;
};

Load load_of(const PairPoints& p, const PairConstants& c, const Frame& f, const PairState& s, const Variations& d) {
  const double tn = s.traction.normal, tt = s.traction.tangential;
  const Row d_tn = s.stiffness.normal * d.normal_gap;
  Row d_tt = s.stiffness.by_normal * d_tn;
  if (s.stiffness.tangential != 0.0)
    d_tt += s.stiffness.tangential *
            (along(f.t, {-(1.0 - c.eta), -c.eta, 0.0, 0.0, 1.0, 0.0}) + (p.anchor - f.y).dot(f.n) * d.spin);
  const double couple = tt * s.normal_gap;
  const Row d_couple = s.normal_gap * d_tt + tt * d.normal_gap;
  return {tn * f.n + tt * f.t, f.n * d_tn + f.t * d_tt + (tt * f.n - tn * f.t) * d.spin, couple, d_couple};
}

// Multiplies by the ramp at a mouth:
// covered = (constant share) - overrun / (share width * length), overrun = -mouth (y - x_E) . t
void fade(const PairPoints& p, const PairConstants& c, const Frame& f, const PairState& s, const Variations& d,
          Load& load) {
  const Vec2 past = f.y - p.mouth;
  Row d_overrun = along(f.t, {1.0 - c.eta, c.eta, 0.0, 0.0, 0.0, -1.0}) + past.dot(f.n) * d.spin;
  d_overrun *= -c.mouth;
  const double overrun = -c.mouth * past.dot(f.t);
  const double width = (c.share_end - c.share_begin) * f.length;
  const Row d_ramp = -(d_overrun - (overrun / f.length) * d.length) / width;
  load.d_traction = s.ramp * load.d_traction + load.traction * d_ramp;
  load.traction *= s.ramp;
  load.d_couple = s.ramp * load.d_couple + load.couple * d_ramp;
  load.couple *= s.ramp;
}

void add_traction(const PairConstants& c, const PairState& s, const Variations& d, const Load& load, PairForce& out) {
  const std::array<double, 4> weight{-(1.0 - c.eta), -c.eta, 1.0 - s.partner, s.partner};
  for (int k = 0; k < 4; ++k) {
    out.force.segment<2>(2 * k) = c.weight * weight[k] * load.traction;
    out.tangent.middleRows<2>(2 * k) = c.weight * weight[k] * load.d_traction;
  }
  out.tangent.middleRows<2>(4) -= c.weight * load.traction * d.xi;
  out.tangent.middleRows<2>(6) += c.weight * load.traction * d.xi;
}

void add_couple(const PairConstants& c, const Frame& f, const Variations& d, const Load& load, PairForce& out) {
  const Vec2 pair_of_forces = load.couple / f.length * f.n;
  const Rows d_pair_of_forces =
      (f.n * load.d_couple - load.couple * f.t * d.spin - load.couple / f.length * f.n * d.length) / f.length;
  out.force.segment<2>(0) -= c.weight * pair_of_forces;
  out.force.segment<2>(2) += c.weight * pair_of_forces;
  out.tangent.middleRows<2>(0) -= c.weight * d_pair_of_forces;
  out.tangent.middleRows<2>(2) += c.weight * d_pair_of_forces;
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
  if (s.ramp == 0.0) {
    s.end = c.begin;
    return s;
  }
  const ContactResponse response =
      respond(c.law, c.springs, {s.normal_gap, s.tangential_gap, c.anchored}, c.touch, c.begin);
  s.traction = response.traction;
  s.stiffness = response.stiffness;
  s.end = response.end;
  return s;
}

// theory (7.4) to (7.6)
PairForce force(const PairPoints& p, const PairConstants& c, const PairState& s) {
  const Frame f = frame(p, c);
  const Variations d = vary(p, c, f, s);
  Load load = load_of(p, c, f, s, d);
  if (s.ramp < 1.0) fade(p, c, f, s, d, load);
  PairForce out;
  add_traction(c, s, d, load, out);
  add_couple(c, f, d, load, out);
  return out;
}

}  // namespace cleft::contact
