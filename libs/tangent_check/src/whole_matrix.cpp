#include "whole_matrix.hpp"

#include <algorithm>

#include "colouring.hpp"
#include "entry.hpp"
#include "tally.hpp"

namespace cleft::tangent_check {
namespace {

VecX largest_of_rows(const assembly::BlockMatrix& matrix) {
  VecX out = VecX::Zero(matrix.rows());
  const auto rows = matrix.scalar_rows();
  for (std::size_t k = 0; k < rows.size(); ++k) out[rows[k]] = std::max(out[rows[k]], std::fabs(matrix.values()[k]));
  return out;
}

}  // namespace

void check_matrix(const assembly::BlockMatrix& matrix, const VecX& u, const std::vector<double>& step,
                  const Evaluate& evaluate, double load, double tolerance, const BlockOfRow& block_of) {
  const VecX scale = largest_of_rows(matrix);
  for (const auto& group : colour_columns(matrix)) {
    std::vector<Index> owner(matrix.size(), kNone);  // of each block row: the column of this group with an entry in it
    double smallest = step[group.front()];
    for (const Index j : group) {
      smallest = std::min(smallest, step[j]);
      for (const Index i : matrix.block_rows(j)) owner[i] = j;
    }
    for (int direction = 0; direction < 2; ++direction) {
      std::array<VecX, kOffsets.size()> force;
      std::vector<bool> kinked(matrix.size(), false);
      for (std::size_t k = 0; k < kOffsets.size(); ++k) {
        VecX there = u;
        for (const Index j : group) there[2 * j + direction] += kOffsets[k] * step[j];
        const WholeForce at = evaluate(there);
        force[k] = at.force;
        for (const Index i : at.kinked) kinked[i] = true;
      }
      for (Index row = 0; row < matrix.rows(); ++row) {
        TangentBlock& block = block_of(row / 2);
        const Index j = owner[row / 2], column = j == kNone ? kNone : 2 * j + direction;
        if (kinked[row / 2]) {
          ++block.left_out;
          continue;
        }
        const auto q =
            quotient({force[0][row], force[1][row], force[2][row], force[3][row]}, j == kNone ? smallest : step[j]);
        if (j == kNone && q.value == 0.0 && q.uncertainty == 0.0) continue;
        count(block, {load, row, column, j == kNone ? 0.0 : entry(matrix, row, column), 0, 0, scale[row], kNone, kNone},
              q, tolerance);
      }
    }
  }
}

}  // namespace cleft::tangent_check
