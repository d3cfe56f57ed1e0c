/// \file
/// Isotropic linear elasticity of small strain, plane strain.
#pragma once

#include "cleft/constitutive/elastic.hpp"
#include "cleft/constitutive/response.hpp"

namespace cleft::constitutive {

/// sigma = lambda tr(eps) 1 + 2 mu eps with eps = sym(H) of the displacement gradient H: the small-strain limit of
/// every hyperelastic material here. `piola` is sigma, and `tangent` d sigma/dH is constant with both minor symmetries.
struct LinearElastic {
  Lame constants;

  /// Strain energy per unit volume, J/m^3.
  double energy(const Mat2& displacement_gradient) const;

  Response respond(const Mat2& displacement_gradient) const;
};

}  // namespace cleft::constitutive
