/// \file
/// Isotropic elastic constants.
#pragma once

namespace cleft::constitutive {

/// Lame constants in Pa.
struct Lame {
  double lambda = 0.0;
  double mu = 0.0;
};

/// From Young's modulus (Pa, positive) and Poisson's ratio (in (-1, 0.5)).
constexpr Lame lame(double young, double poisson) {
  return {young * poisson / ((1.0 + poisson) * (1.0 - 2.0 * poisson)), young / (2.0 * (1.0 + poisson))};
}

/// Bulk modulus in three dimensions, Pa.
constexpr double bulk_modulus(const Lame& c) { return c.lambda + 2.0 / 3.0 * c.mu; }

/// Modulus of uniaxial strain, Pa.
constexpr double uniaxial_strain_modulus(const Lame& c) { return c.lambda + 2.0 * c.mu; }

}  // namespace cleft::constitutive
