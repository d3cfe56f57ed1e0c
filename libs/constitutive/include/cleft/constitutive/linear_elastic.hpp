/// \file
/// Isotropic linear elasticity of small strain, plane strain.
#pragma once

#include "cleft/constitutive/elastic.hpp"
#include "cleft/constitutive/response.hpp"

namespace cleft::constitutive {

/// sigma = lambda tr(eps) 1 + 2 mu eps with eps = sym(F) - 1: the small-strain limit of every hyperelastic material
/// here. It takes F as the others do; `piola` is sigma, and `tangent` d sigma/dF is constant with both minor
/// symmetries.
struct LinearElastic {
  Lame constants;

  /// Strain energy per unit volume, J/m^3.
  double energy(const Mat2& deformation) const;

  Response respond(const Mat2& deformation) const;
};

}  // namespace cleft::constitutive
