#include "newton_failures.hpp"

namespace cleft::solve {

using assembly::FailureKind;

Extreme largest(const VecX& values) {
  Eigen::Index at = 0;
  const double size = values.cwiseAbs().maxCoeff(&at);
  return {static_cast<Index>(at), size};
}

assembly::Failure unbalanced(const assembly::Model& model, const Iteration& last, int iterations, const VecX& residual,
                             int halved) {
  return {FailureKind::NoConvergence,
          assembly::Unbalanced{last.residual, iterations, position_of(model, largest(residual).component),
                               last.status_changes + last.partner_changes, halved}};
}

assembly::Failure useless(const assembly::Model& model, Factors factors, const VecX& correction) {
  if (factors == Factors::None) return {FailureKind::Singular, assembly::NoCorrection{}};
  if (!correction.allFinite())
    return {factors == Factors::Regular ? FailureKind::NotFinite : FailureKind::Singular, assembly::NoCorrection{}};
  const auto [component, size] = largest(correction);
  return {FailureKind::Singular, assembly::FarCorrection{position_of(model, component), size}};
}

assembly::Failure left_behind(const assembly::Model& model, const VecX& moved) {
  const auto [component, size] = largest(moved);
  return {FailureKind::Singular, assembly::LostPart{position_of(model, component), size}};
}

}  // namespace cleft::solve
