#include "flow.hpp"

#include <algorithm>

namespace cleft::solve {

double largest_flow(const assembly::Model& model, const std::vector<constitutive::PlasticState>& before,
                    const std::vector<constitutive::PlasticState>& now) {
  double out = 0.0;
  for (std::size_t p = 0; p < std::min(now.size(), model.cells.size()); ++p)
    out = std::max(out, now[p].accumulated - before[p].accumulated);
  return out;
}

}  // namespace cleft::solve
