#include "difference.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cleft::tangent_check {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

Lengths lengths_of(const assembly::Model& model, const VecX& u) {
  Lengths out;
  out.influence.assign(model.unknowns.count, std::numeric_limits<double>::infinity());
  out.stiffness.assign(model.unknowns.count, 0.0);
  assembly::for_each_material_point(model, [&](std::size_t p, const auto& point, double weight) {
    const double modulus = constitutive::uniaxial_strain_modulus(model.constants(static_cast<Index>(p)));
    for (std::size_t k = 0; k < point.unknown.size(); ++k) {
      double &length = out.influence[point.unknown[k]], &stiffness = out.stiffness[point.unknown[k]];
      length = std::min(length, 1.0 / point.gradient[k].norm());
      stiffness = std::max(stiffness, weight * modulus * point.gradient[k].squaredNorm());
    }
  });
  for (Index k = 0; k < model.unknowns.multipliers; ++k)
    out.influence[model.unknowns.displacements() + k] = model.surfaces.multiplier_space.nodes[k].length;
  for (double& length : out.influence)
    if (!std::isfinite(length)) length = 1.0;  // of a node that no cell uses: nothing depends on it
  for (const auto& node : model.mesh.nodes) out.reach = std::max(out.reach, node.norm());
  out.reach += u.cwiseAbs().maxCoeff();
  return out;
}

double first_step(double influence, double reach) {
  const double step = influence * std::cbrt(kEpsilon * std::max(1.0, reach / influence));
  return std::exp2(std::round(std::log2(step)));
}

double least_step(double reach, double tolerance) { return 4.0 * kEpsilon * reach / tolerance; }

Quotient quotient(const std::array<double, 4>& force, double step) {
  const double narrow = (force[2] - force[1]) / (2.0 * step), wide = (force[3] - force[0]) / (4.0 * step);
  return {narrow + (narrow - wide) / 3.0, std::fabs(narrow - wide)};
}

bool count(TangentBlock& block, TangentEntry entry, const Quotient& difference, double tolerance) {
  if (!is_certain(difference, entry.scale, tolerance)) {
    ++block.left_out;
    return false;
  }
  entry.difference = difference.value;
  entry.uncertainty = difference.uncertainty;
  entry.scale = std::fmax(entry.scale, std::fabs(difference.value));
  ++block.entries;
  if (block.entries == 1 || !(entry.error() <= block.worst.error())) block.worst = entry;
  return true;
}

}  // namespace cleft::tangent_check
