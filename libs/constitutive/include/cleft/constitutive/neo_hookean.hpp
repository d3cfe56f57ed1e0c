/// \file
/// Compressible neo-Hookean hyperelasticity, plane strain.
#pragma once

#include "cleft/constitutive/elastic.hpp"
#include "cleft/constitutive/response.hpp"

namespace cleft::constitutive {

/// W = mu/2 (tr b - 3) - mu ln J + lambda/2 (ln J)^2, that is tau = mu (b - 1) + lambda ln J 1.
struct NeoHookean {
  Lame constants;

  /// Strain energy per unit reference volume, J/m^3. Needs det F > 0.
  double energy(const Mat2& deformation) const;

  /// Stress and tangent. Needs det F > 0.
  Response respond(const Mat2& deformation) const;
};

}  // namespace cleft::constitutive
