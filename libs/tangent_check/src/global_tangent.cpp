#include "global_tangent.hpp"

#include <algorithm>
#include <utility>

#include "colouring.hpp"
#include "difference.hpp"

namespace cleft::tangent_check {
namespace {

VecX largest_of_rows(const assembly::BlockMatrix& matrix) {
  VecX out = VecX::Zero(matrix.rows());
  const auto rows = matrix.scalar_rows();
  for (std::size_t k = 0; k < rows.size(); ++k) out[rows[k]] = std::max(out[rows[k]], std::fabs(matrix.values()[k]));
  return out;
}

// Columns of unknowns that are moved at the same time: no two have a row in common.
class ColumnGroup {
 public:
  ColumnGroup(const MatrixCheck& check, const VecX& scale, const std::vector<Index>& columns)
      : check_(check), scale_(scale), columns_(columns), owner_(check.matrix.size(), kNone) {
    smallest_ = check.step[columns.front()];
    for (const Index j : columns) {
      smallest_ = std::min(smallest_, check.step[j]);
      for (const Index i : check.matrix.block_rows(j)) owner_[i] = j;
    }
  }

  /// Moves the columns along x (0) or y (1) and compares every row.
  void compare(int direction) const {
    const Forces forces = forces_along(direction);
    for (Index row = 0; row < check_.matrix.rows(); ++row) compare(row, direction, forces);
  }

 private:
  struct Forces {
    std::array<VecX, kOffsets.size()> at;  // the offsets
    std::vector<bool> kinked;              // of each block row: not differentiable between them
  };

  Forces forces_along(int direction) const {
    Forces out{{}, std::vector<bool>(check_.matrix.size(), false)};
    for (std::size_t k = 0; k < kOffsets.size(); ++k) {
      VecX there = check_.u;
      for (const Index j : columns_) there[2 * j + direction] += kOffsets[k] * check_.step[j];
      GlobalForce at = check_.evaluate(there);
      out.at[k] = std::move(at.force);
      for (const Index i : at.kinked) out.kinked[i] = true;
    }
    return out;
  }

  void compare(Index row, int direction, const Forces& forces) const {
    TangentBlock* block = check_.block_of(row / 2);
    if (!block) return;
    if (forces.kinked[row / 2]) {
      ++block->left_out;
      return;
    }
    const Index j = owner_[row / 2];
    const auto q = quotient({forces.at[0][row], forces.at[1][row], forces.at[2][row], forces.at[3][row]},
                            j == kNone ? smallest_ : check_.step[j]);
    if (j == kNone && q.value == 0.0 && q.uncertainty == 0.0) return;
    TangentEntry compared{.load = check_.load, .row = row, .scale = scale_[row]};
    if (j != kNone) {
      compared.column = 2 * j + direction;
      compared.exact = check_.matrix.entry(row, compared.column);
    }
    count(*block, compared, q, check_.tolerance);
  }

  const MatrixCheck& check_;
  const VecX& scale_;  // largest entry of each row
  const std::vector<Index>& columns_;
  std::vector<Index> owner_;  // of each block row: the column of this group with an entry in it
  double smallest_ = 0.0;     // step
};

}  // namespace

void check_matrix(const MatrixCheck& check) {
  VecX scale = largest_of_rows(check.matrix);
  if (check.faint > 0.0) scale = scale.cwiseMax(check.faint * scale.maxCoeff()).eval();
  for (const auto& columns : colour_columns(check.matrix)) {
    const ColumnGroup group(check, scale, columns);
    for (const int direction : {0, 1}) group.compare(direction);
  }
}

}  // namespace cleft::tangent_check
