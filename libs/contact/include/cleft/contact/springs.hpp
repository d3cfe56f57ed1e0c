/// \file
/// Penalty contact at one point of a crack's negative face: springs that stand for exact contact.
///
/// The point y, its current tangent t (along the crack's direction) and the outward normal n of the negative body meet
/// the opposite (positive) face at its partner x_B, where the line y + g n crosses it. With the anchor x_A, a material
/// point of the positive face, and the strength of the interface law at the pressure p = -t_N,
///
///     g_N = (x_B - y) . n,     t_N = eps_N g_N if g_N < 0, else no traction,
///     g_T = (x_A - y) . t,     trial t_T = eps_T g_T,
///     stick   |t_T| <= strength:   t_0 = t_N n + t_T t                       (Liu and Borja 2010, (60))
///     slip    else:                t_0 = t_N n + strength sign(g_T) t        (59)
///
/// Tractions are per unit reference area of the negative face; t_N < 0 presses; g_N < 0 is a penetration. The springs
/// are the method's and not the law's: the law knows nothing but strength.
#pragma once

#include "cleft/contact/interface_law.hpp"
#include "cleft/contact/traction.hpp"

namespace cleft::contact {

struct Springs {
  double normal = 0.0;      ///< eps_N, Pa/m
  double tangential = 0.0;  ///< eps_T, Pa/m

  /// Energy in the springs that bear these tractions, J/m^2 of reference area.
  double stored_energy(double normal_traction, double tangential_traction) const {
    return 0.5 * (normal_traction * normal_traction / normal + tangential_traction * tangential_traction / tangential);
  }
};

/// Gaps of a point, metres.
struct Gaps {
  double normal = 0.0;      ///< g_N
  double tangential = 0.0;  ///< g_T; 0 without an anchor
  bool anchored = false;    ///< else the point touches for the first time: it takes hold where it is, without t_T
};

/// Derivatives of a traction. With the chain through t_N, d t_T = tangential d g_T + by_normal normal d g_N.
struct Stiffness {
  double normal = 0.0;      ///< d t_N / d g_N, Pa/m
  double tangential = 0.0;  ///< d t_T / d g_T, Pa/m; 0 where the point slides
  double by_normal = 0.0;   ///< d t_T / d t_N, 1; 0 where it sticks
};

struct ContactResponse {
  Traction traction;
  Stiffness stiffness;
  InterfaceState end;  ///< of the law, should the increment end here
};

/// Traction at the gaps, from the state `begin` at which the increment begins.
ContactResponse respond(const InterfaceLaw& law, const Springs& springs, const Gaps& gaps, Touch touch,
                        const InterfaceState& begin);

}  // namespace cleft::contact
