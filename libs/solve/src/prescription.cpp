#include "prescription.hpp"

#include <algorithm>

namespace cleft::solve {
namespace {

Prescription at(const assembly::Model& model, const std::vector<assembly::Constraint>& constraints, double load) {
  return {dead_force(model, load), prescribed_values(model, constraints, load)};
}

}  // namespace

Prescription rate_of(const assembly::Model& model, const std::vector<assembly::Constraint>& constraints, double load) {
  constexpr double kStep = 1e-6;
  const double above = std::min(load + kStep, 1.0), below = above - 2.0 * kStep;
  const Prescription upper = at(model, constraints, above), lower = at(model, constraints, below);
  return {(upper.dead - lower.dead) / (above - below), (upper.displacement - lower.displacement) / (above - below)};
}

Prescription prescription(const assembly::Model& model, const std::vector<assembly::Constraint>& constraints,
                          double load) {
  if (load <= 1.0) return at(model, constraints, load);
  Prescription out = at(model, constraints, 1.0);
  const Prescription rate = rate_of(model, constraints, 1.0);
  out.dead += (load - 1.0) * rate.dead;
  out.displacement += (load - 1.0) * rate.displacement;
  return out;
}

bool turns_back(const assembly::Model& model, const std::vector<assembly::Constraint>& constraints, double load) {
  constexpr double kBeside = 1e-5;
  const Prescription below = rate_of(model, constraints, load - kBeside),
                     above = rate_of(model, constraints, load + kBeside);
  const double forces = below.dead.dot(above.dead), motions = below.displacement.dot(above.displacement);
  return forces < 0.0 || motions < 0.0 || !(forces + motions > 0.0);
}

bool changes(const Prescription& rate) { return !rate.dead.isZero(0.0) || !rate.displacement.isZero(0.0); }

}  // namespace cleft::solve
