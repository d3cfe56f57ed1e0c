// Orders of convergence.
#pragma once

#include <vector>

namespace cleft::verification {

/// The order p of errors that fall like h^p: slope of the least-squares line through (log h, log error). Two pairs or
/// more, all positive.
double order_of(const std::vector<double>& h, const std::vector<double>& error);

}  // namespace cleft::verification
