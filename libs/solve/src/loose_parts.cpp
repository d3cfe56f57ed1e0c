#include "loose_parts.hpp"

#include "cleft/support/disjoint_sets.hpp"

namespace cleft::solve {
namespace {

constexpr double kSoft = 1e-6;  // of the modulus; the part's load times its inverse must be seen to be too much

}  // namespace

std::vector<Index> loose_unknowns(const assembly::Model& model, const std::vector<assembly::Constraint>& constraints) {
  const Index count = model.unknowns.displacements();
  DisjointSets parts(count);
  for_each_material_point(model, [&](std::size_t, const auto& point, double) {
    for (const Index unknown : point.unknown) parts.join(unknown, point.unknown[0]);
  });
  std::vector<bool> held(static_cast<std::size_t>(count), false);
  for (const auto& constraint : constraints) held[parts.of(constraint.component / 2)] = true;
  std::vector<Index> out;
  for (Index unknown = 0; unknown < count; ++unknown)
    if (!held[parts.of(unknown)]) out.push_back(unknown);
  return out;
}

std::optional<VecX> correction_with_parts_held(const assembly::Model& model,
                                               const std::vector<assembly::Constraint>& constraints, const VecX& rhs,
                                               double bound, assembly::BlockMatrix& matrix, LinearSolver& solver) {
  const auto loose = loose_unknowns(model, constraints);
  if (loose.empty()) return std::nullopt;
  for (const Index unknown : loose)
    matrix.add(matrix.find(unknown, unknown), kSoft * model.stiffness() * Mat2::Identity());
  if (solver.factorise(matrix) != Factors::Regular) return std::nullopt;
  VecX du = solver.solve(rhs);
  if (!du.allFinite()) return std::nullopt;
  for (const Index unknown : loose)
    if (du.segment<2>(2 * unknown).norm() > bound) return std::nullopt;
  return du;
}

}  // namespace cleft::solve
