// Comparisons as a table.
#pragma once

#include <string>
#include <vector>

#include "comparison.hpp"

namespace cleft::verification {

/// One line a comparison, columns aligned; the reasons of the tolerances follow, numbered, each once.
std::string table_of(const std::vector<Comparison>& rows);

}  // namespace cleft::verification
