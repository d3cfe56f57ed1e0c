#include "boundary_values.hpp"

namespace cleft::solve {

VecX missing_motion(const std::vector<assembly::Constraint>& constraints, const VecX& target, const VecX& u) {
  VecX out(target.size());
  for (std::size_t k = 0; k < constraints.size(); ++k) out[k] = target[k] - u[constraints[k].component];
  return out;
}

void prescribe(const std::vector<assembly::Constraint>& constraints, const VecX& change, double diagonal,
               const assembly::BlockMatrix& matrix, VecX& rhs) {
  if (change.size() == 0) return;
  if (change.cwiseAbs().maxCoeff() > 0.0) {
    VecX full = VecX::Zero(rhs.size());
    for (std::size_t k = 0; k < constraints.size(); ++k) full[constraints[k].component] = change[k];
    rhs -= matrix.multiply(full);
  }
  for (std::size_t k = 0; k < constraints.size(); ++k) rhs[constraints[k].component] = diagonal * change[k];
}

void eliminate(const std::vector<assembly::Constraint>& constraints, double diagonal, assembly::BlockMatrix& matrix) {
  auto values = matrix.values();
  for (const auto& constraint : constraints) {
    const Index c = constraint.component, block = c / 2, direction = c % 2;
    for (const Index row : matrix.block_rows(block)) {
      const auto down = matrix.find(row, block), across = matrix.find(block, row);
      for (int i = 0; i < 2; ++i) {
        values[down.start + direction * down.stride + i] = 0.0;
        values[across.start + i * across.stride + direction] = 0.0;
      }
    }
    const auto own = matrix.find(block, block);
    values[own.start + direction * own.stride + direction] = diagonal;
  }
}

void move_boundary(const std::vector<assembly::Constraint>& constraints, const VecX& target, VecX& u, VecX& change) {
  for (std::size_t k = 0; k < constraints.size(); ++k) u[constraints[k].component] = target[k];
  change.setZero();
}

}  // namespace cleft::solve
