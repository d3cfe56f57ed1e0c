#include "tangent_factors.hpp"

namespace cleft::solve {

Factors factorise_propped(const assembly::Model& model, assembly::BlockMatrix& matrix, LinearSolver& solver) {
  constexpr double kLeast = 1e-9;  // of the modulus: a condition of the matrix that the solution bears
  for (Index unknown = 0; unknown < model.unknowns.displacements(); ++unknown)
    matrix.add(matrix.find(unknown, unknown), kLeast * model.stiffness() * Mat2::Identity());
  return solver.factorise(matrix);
}

Pivots pivots_of_body(const LinearSolver& solver, const assembly::Assembler& assembler) {
  Pivots out = solver.pivots();
  for (const auto& condition : assembler.multipliers().conditions())
    for (int row = 0; row < 2; ++row) out.negative_determinant ^= !(condition.by_own(row, row) > 0.0);
  return out;
}

bool old_factors_do(const std::vector<Iteration>& before, const Iteration& now, const NewtonControls& controls) {
  constexpr double kMargin = 0.1;  // a step that is not the last one was in vain
  const bool last = static_cast<int>(before.size()) + 1 >= controls.min_iterations;
  if (!last || before.empty() || before.back().kept || before.back().cycles) return false;
  if (now.status_changes + now.partner_changes > 0) return false;
  return 2.0 * now.residual * now.residual <= kMargin * controls.residual_tolerance * before.back().residual;
}

}  // namespace cleft::solve
