#include "flow.hpp"

namespace cleft::assembly {

bool flows_far(const Model& model, const std::vector<constitutive::PlasticState>& before,
               const std::vector<constitutive::PlasticState>& now) {
  constexpr double kFar = 0.1;  // growth of the plastic multiplier
  if (now.empty()) return false;
  for (std::size_t p = 0; p < model.cells.size(); ++p)
    if (now[p].accumulated - before[p].accumulated > kFar) return true;
  return false;
}

}  // namespace cleft::assembly
