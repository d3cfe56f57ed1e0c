#include "global_tangent.hpp"

#include <algorithm>
#include <optional>
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
    smallest_ = *std::ranges::min_element(columns, {}, [&](Index j) { return check.steps.first[j]; });
    for (const Index j : columns)
      for (const Index i : check.matrix.block_rows(j)) owner_[i] = j;
  }

  /// Moves the columns along x (0) or y (1) and compares every row, by smaller steps where there is a kink within the
  /// first ones or they leave too much to doubt.
  void compare(int direction) const {
    std::vector<std::optional<Quotient>> best(check_.matrix.rows());
    for (const double factor : kFactors) {
      const Forces forces = forces_along(direction, factor);
      bool all = true;
      for (Index row = 0; row < check_.matrix.rows(); ++row) all &= improve(row, forces, factor, best[row]);
      if (all) break;
    }
    for (Index row = 0; row < check_.matrix.rows(); ++row) judge(row, direction, best[row]);
  }

 private:
  static constexpr std::array<double, 3> kFactors{1.0, 1.0 / 16, 1.0 / 256};

  struct Forces {
    std::array<VecX, kOffsets.size()> at;  // the offsets
    std::vector<bool> kinked;              // of each block row: not differentiable between them
  };

  double step(Index column, double factor) const {
    return std::max(factor * check_.steps.first[column], check_.steps.least);
  }

  Forces forces_along(int direction, double factor) const {
    Forces out{{}, std::vector<bool>(check_.matrix.size(), false)};
    for (std::size_t k = 0; k < kOffsets.size(); ++k) {
      VecX there = check_.u;
      for (const Index j : columns_) there[2 * j + direction] += kOffsets[k] * step(j, factor);
      GlobalForce at = check_.evaluate(there);
      out.at[k] = std::move(at.force);
      for (const Index i : at.kinked) out.kinked[i] = true;
    }
    return out;
  }

  // Takes the quotient of these forces if it is less uncertain; true if what there is can be judged.
  bool improve(Index row, const Forces& forces, double factor, std::optional<Quotient>& best) const {
    if (best && is_certain(*best, scale_[row], check_.tolerance)) return true;
    if (forces.kinked[row / 2]) return !check_.block_of(row / 2);
    const Index j = owner_[row / 2];
    const auto q = quotient({forces.at[0][row], forces.at[1][row], forces.at[2][row], forces.at[3][row]},
                            step(j == kNone ? smallest_ : j, factor));
    if (!best || q.uncertainty < best->uncertainty) best = q;
    return is_certain(*best, scale_[row], check_.tolerance);
  }

  void judge(Index row, int direction, const std::optional<Quotient>& q) const {
    TangentBlock* block = check_.block_of(row / 2);
    if (!block) return;
    if (!q) {
      ++block->left_out;
      return;
    }
    const Index j = owner_[row / 2];
    if (j == kNone && q->value == 0.0 && q->uncertainty == 0.0) return;
    TangentEntry compared{.load = check_.load, .row = row, .scale = scale_[row]};
    if (j != kNone) {
      compared.column = 2 * j + direction;
      compared.exact = check_.matrix.entry(row, compared.column);
    }
    count(*block, compared, *q, check_.tolerance);
  }

  const MatrixCheck& check_;
  const VecX& scale_;  // largest entry of each row
  const std::vector<Index>& columns_;
  std::vector<Index> owner_;  // of each block row: the column of this group with an entry in it
  Index smallest_ = kNone;    // the column with the smallest step
};

}  // namespace

void check_matrix(const MatrixCheck& check) {
  VecX scale = largest_of_rows(check.matrix);
  if (check.least_scale.size() > 0) scale = scale.cwiseMax(check.least_scale).eval();
  for (const auto& columns : colour_columns(check.matrix)) {
    const ColumnGroup group(check, scale, columns);
    for (const int direction : {0, 1}) group.compare(direction);
  }
}

}  // namespace cleft::tangent_check
