#include "flow.hpp"

#include <algorithm>

#include "cleft/assembly/f_bar.hpp"

namespace cleft::solve {

double largest_flow(const assembly::Model& model, const std::vector<constitutive::PlasticState>& before,
                    const std::vector<constitutive::PlasticState>& now) {
  double out = 0.0;
  for (std::size_t p = 0; p < std::min(now.size(), model.cells.size()); ++p)
    out = std::max(out, now[p].accumulated - before[p].accumulated);
  return out;
}

bool is_on_apex(const assembly::Model& model, Index point, const VecX& displacement,
                const constitutive::PlasticState& now) {
  return std::visit(
      [&]<class Law>(const Law& law) {
        if constexpr (constitutive::PathDependent<Law>)
          return law.friction > 0.0 && law.is_on_apex(assembly::material_deformation(model, point, displacement), now);
        return false;
      },
      model.material(point));
}

}  // namespace cleft::solve
