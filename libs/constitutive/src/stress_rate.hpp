/// \file
/// The part of the tangent that finite and small strain share.
#pragma once

#include <array>

#include "cleft/constitutive/drucker_prager.hpp"

namespace cleft::constitutive {

/// The trial elastic deformation as far as its rate needs it: w and B of logarithm.hpp. At small strain both are zero.
struct CircleShape {
  Vec2 w = Vec2::Zero();
  double remainder = 0.0;
};

/// tr g of the same.
Eigen::RowVector4d volume_rate();

/// n : de over dg for the rate de of the trial elastic strain, g = dF F^-1: a linear function of (g_11, g_21, g_12,
/// g_22).
Eigen::RowVector4d rate_along(const PlaneTensor& n, const CircleShape& shape);

/// d tau_ij / d g_kl with g = dF F^-1: the moduli (direction n) times the rate of the trial elastic strain.
Mat4 stress_rate(const Moduli& moduli, const PlaneTensor& n, const CircleShape& shape);

}  // namespace cleft::constitutive
