#include "colouring.hpp"

namespace cleft::tangent_check {

std::vector<std::vector<Index>> colour_columns(const assembly::BlockMatrix& matrix) {
  std::vector<std::vector<Index>> groups;
  std::vector<Index> colour(matrix.size(), kNone), taken_by;
  for (Index j = 0; j < matrix.size(); ++j) {
    // the pattern is symmetric: the columns with a block in row i are the rows of column i
    for (const Index i : matrix.block_rows(j))
      for (const Index k : matrix.block_rows(i))
        if (colour[k] != kNone) taken_by[colour[k]] = j;
    Index free = 0;
    while (free < static_cast<Index>(groups.size()) && taken_by[free] == j) ++free;
    if (free == static_cast<Index>(groups.size())) {
      groups.emplace_back();
      taken_by.push_back(kNone);
    }
    colour[j] = free;
    groups[free].push_back(j);
  }
  return groups;
}

}  // namespace cleft::tangent_check
