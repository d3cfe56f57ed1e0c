/// \file
/// Residual and consistent tangent of one contact point and its partner, in the ends of the segments that they lie on.
#pragma once

#include <array>

#include "cleft/contact/springs.hpp"
#include "cleft/support/types.hpp"

namespace cleft::contact {

/// Current positions that one pair depends on, metres. A pair is a function of these six points.
struct PairPoints {
  Vec2 negative_start, negative_end;  ///< segment of the negative face that carries the point
  Vec2 positive_start, positive_end;  ///< segment of the positive face that carries the partner
  Vec2 anchor;                        ///< x_A
  Vec2 mouth;                         ///< the free end of the positive face that the point may run past
};
inline constexpr int kPairInputs = 12;  ///< components of PairPoints, in the order of its members
inline constexpr int kPairOutputs = 8;  ///< forces on the four segment ends, in the same order

/// What does not change while the body moves.
struct PairConstants {
  InterfaceLaw law;
  Springs springs;
  InterfaceState begin;  ///< of the law, at the begin of the increment
  Touch touch;
  double weight = 0.0;       ///< reference length that the point stands for, metres (unit thickness)
  double eta = 0.0;          ///< the point's place on its segment, 0 at the start, 1 at the end
  double share_begin = 0.0;  ///< the part of the segment that the point stands for,
  double share_end = 0.0;    ///< share_begin <= eta <= share_end
  double normal_sign = 1.0;  ///< n is this times the tangent turned left
  bool anchored = false;
  int mouth = 0;  ///< 0: no free end near; +1: body of the positive face lies ahead (along t) of it; -1: behind
};

/// Gaps, tractions and the partner at the current positions.
struct PairState {
  Traction traction;
  Stiffness stiffness;          ///< of the springs; mortar contact has none
  InterfaceState end;           ///< of the law, should the increment end here
  double normal_gap = 0.0;      ///< g_N, metres
  double tangential_gap = 0.0;  ///< g_T, metres; 0 without an anchor
  double partner = 0.0;         ///< the partner's place on its segment (outside [0, 1] past a mouth)
  double slope = 0.0;           ///< (e . n) / (e . t): the partner's segment e against the point's own tangent
  double ramp = 1.0;            ///< part of the point's share that still has the positive face opposite
  double stretch_length = 0.0;  ///< current length of the negative segment, metres
};

/// Evaluates gaps and tractions.
PairState evaluate(const PairPoints& points, const PairConstants& constants);

/// Internal force (N/m) on the four segment ends, and its derivative with respect to all six points.
struct PairForce {
  Eigen::Matrix<double, kPairOutputs, 1> force;
  Eigen::Matrix<double, kPairOutputs, kPairInputs> tangent;
};

/// The internal force of a closed pair, conjugate to the displacement jump and the spin of the point's segment,
///
///     f = W (N_+ - N_-)^T t_0 + W t_T g_N dth/dq,
///
/// and its exact derivative. The second term is not in Liu and Borja 2010: t_T acts at the point and at its partner, a
/// penetration apart, and without a couple that takes up their moment a rigid turn does work (7 % of all work in the
/// scene rotation.toml, whose faces overlap by 1.5 % of an element). It vanishes with the penetration.
///
///     dth  = n . d(tangent vector) / |tangent vector|,      dt = n dth,     dn = -t dth
///     dxi  = -[(dx_B - dy) . t + g_N dth] / (e . t)         (dx_B at fixed xi; e the partner's segment)
///     dg_N = (dx_B - dy) . n + (e . n) dxi
///     dg_T = (dx_A - dy) . t + ((x_A - y) . n) dth
///     df   = W (N_+ - N_-)^T dt_0 + W (dN_+/dxi)^T t_0 dxi
///
/// (first term). The last term is not in Liu and Borja 2010, (89)-(92): the weight functions at the partner move along
/// the positive face, too. Without it the iteration is not quadratic while the faces slide. Everything is multiplied by
/// the ramp at a mouth, whose derivative is included.
PairForce force(const PairPoints& points, const PairConstants& constants, const PairState& state);

}  // namespace cleft::contact
