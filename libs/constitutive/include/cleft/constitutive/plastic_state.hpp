/// \file
/// What a plastic material remembers of its past at one point.
#pragma once

#include <array>
#include <concepts>
#include <functional>
#include <span>

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
  /// volumetric plastic strain divided by the dilatancy. In a patch that is so of the mean of both points by volume.
  double accumulated = 0.0;

  bool operator==(const PlasticState&) const = default;
};

/// A history and how much it counts for in a mean: the area that has it, positive.
struct WeightedState {
  double weight = 0.0;
  PlasticState state;
};

/// Mean of every entry of what `measure` makes of the histories; where that is one for all, it to the last bit. At rest
/// if there are none.
template <class Measure = std::identity>
PlasticState linear_mean(std::span<const WeightedState> states, const Measure& measure = {}) {
  PlasticState mean;
  double sum = 0.0;
  for (const WeightedState& next : states) {
    const PlasticState measured = measure(next.state);
    const double part = next.weight / (sum += next.weight);
    const auto draw = [part](double& entry, double to) { entry += part * (to - entry); };
    for (std::size_t k = 0; k < mean.deformation.size(); ++k) draw(mean.deformation[k], measured.deformation[k]);
    draw(mean.accumulated, measured.accumulated);
  }
  return mean;
}

/// A law whose answer depends on the past: it reads the state at the begin of the step and writes the one at its end.
template <class Law>
concept PathDependent = requires(const Law& law, const Mat2& F, const PlasticState& committed, PlasticState& trial) {
  { law.respond(F, committed, trial) } -> std::same_as<Response>;
};

}  // namespace cleft::constitutive
