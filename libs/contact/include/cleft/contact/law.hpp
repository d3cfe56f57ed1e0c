/// \file
/// Penalty contact with Coulomb friction at one point of a crack's negative face.
///
/// The point y, its current tangent t (along the crack's direction) and the outward normal n of the negative body meet
/// the opposite (positive) face at its partner x_B, where the line y + g n crosses it. With the anchor x_A, a material
/// point of the positive face,
///
///     g_N = (x_B - y) . n,     t_N = eps_N g_N if g_N < 0, else no traction,
///     g_T = (x_A - y) . t,     trial t_T = eps_T g_T,
///     stick   |t_T| + mu t_N <= 0:   t_0 = t_N n + t_T t                 (Liu and Borja 2010, (60))
///     slip    else:                  t_0 = t_N n - mu t_N sign(g_T) t    (59)
///
/// Tractions are per unit reference area of the negative face; t_N < 0 presses; g_N < 0 is a penetration.
#pragma once

#include "cleft/support/types.hpp"

namespace cleft::contact {

struct Law {
  double normal_penalty = 0.0;      ///< eps_N, Pa/m
  double tangential_penalty = 0.0;  ///< eps_T, Pa/m
  double friction = 0.0;            ///< Coulomb's coefficient mu
};

enum class Status : std::uint8_t { Open, Stick, Slip };

/// A gap or a slip below this length is rounding: it neither opens a point nor makes it slide. Metres.
struct Touch {
  double length = 0.0;
};

/// Traction at one point.
struct Traction {
  Status status = Status::Open;
  double normal = 0.0;      ///< t_N, Pa
  double tangential = 0.0;  ///< t_T, Pa
};

/// The law. `anchored` is false where the point has no anchor yet (its first touch): it takes hold where it is,
/// without tangential traction.
Traction traction(const Law& law, double normal_gap, double tangential_gap, bool anchored, Touch touch);

}  // namespace cleft::contact
