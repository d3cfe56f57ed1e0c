/// \file
/// What a plastic material remembers of its past at one point.
#pragma once

#include <array>
#include <concepts>

#include "cleft/constitutive/response.hpp"

namespace cleft::constitutive {

/// History of one point; all zero at rest. Elastic steps leave it as it is, to the last bit.
struct PlasticState {
  /// Components 11, 22, 12, 33 of the plastic deformation, in the reference configuration.
  /// Finite strain: C^p^-1 - I with C^p = F^p^T F^p, so that the elastic b^e is F C^p^-1 F^T and an earlier F is not
  /// needed. Small strain: the plastic strain itself (12 is the tensor component). The identity is taken off, so that
  /// small plastic strains keep all their digits.
  std::array<double, 4> deformation{};

  /// Sum of the plastic multipliers. Off the apex it is the sum of |deviatoric plastic strain increment| (Frobenius
  /// norm), that is sqrt(3/2) times the equivalent plastic strain of J2 plasticity; on the apex of a cone it is the
  /// volumetric plastic strain divided by the dilatancy.
  double accumulated = 0.0;
};

/// A law whose answer depends on the past: it reads the state at the begin of the step and writes the one at its end.
template <class Law>
concept PathDependent = requires(const Law& law, const Mat2& F, const PlasticState& committed, PlasticState& trial) {
  { law.respond(F, committed, trial) } -> std::same_as<Response>;
};

}  // namespace cleft::constitutive
