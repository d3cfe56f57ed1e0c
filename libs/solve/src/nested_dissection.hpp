// Order of elimination by nested dissection.
#pragma once

#include <vector>

#include "cleft/assembly/block_matrix.hpp"

namespace cleft::solve {

/// The position of every scalar row in the order of elimination, from 0, by METIS on the graph of the blocks; the two
/// rows of a block follow each other.
std::vector<Index> nested_dissection(const assembly::BlockMatrix& matrix);

}  // namespace cleft::solve
