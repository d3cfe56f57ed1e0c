#include "nested_dissection.hpp"

#include <metis.h>

#include <new>

namespace cleft::solve {

std::vector<Index> nested_dissection(const assembly::BlockMatrix& matrix) {
  static_assert(sizeof(idx_t) == sizeof(Index));
  idx_t size = matrix.size();
  std::vector<idx_t> starts(1, 0), neighbours;
  starts.reserve(static_cast<std::size_t>(size) + 1);
  neighbours.reserve(static_cast<std::size_t>(matrix.nonzeros() / 4));
  for (Index j = 0; j < size; ++j) {
    for (const Index i : matrix.block_rows(j))
      if (i != j) neighbours.push_back(i);
    starts.push_back(static_cast<idx_t>(neighbours.size()));
  }
  std::vector<idx_t> order(static_cast<std::size_t>(size)), position(static_cast<std::size_t>(size));
  // of its failures only one can happen here
  if (METIS_NodeND(&size, starts.data(), neighbours.data(), nullptr, nullptr, order.data(), position.data()) !=
      METIS_OK)
    throw std::bad_alloc();
  std::vector<Index> rows(2 * position.size());
  for (std::size_t k = 0; k < position.size(); ++k) {
    rows[2 * k] = 2 * position[k];
    rows[2 * k + 1] = 2 * position[k] + 1;
  }
  return rows;
}

}  // namespace cleft::solve
