#include "growth_check.hpp"

#include <tuple>

#include "cleft/problem/tip_reach.hpp"

namespace cleft::problem {

void refuse_idle_growth(const Specification& specification, const assembly::Model& m) {
  for (Index c = 0; c < static_cast<Index>(specification.cracks.size()); ++c) {
    const auto& [law, at] = std::tie(specification.cracks[c].growth, specification.cracks[c].growth_at);
    if (!law) continue;
    const auto* rankine = std::get_if<Rankine>(&law->criterion);
    int tips = 0;
    for (const int end : {0, 1}) {
      if (!law->tips[end] || m.cut.cracks[c].ends[end].kind != geometry::CrackEnd::Kind::Tip) continue;
      ++tips;
      if (rankine && !spans_elements(m, c, end, rankine->radius))
        throw InputError(
            at, at.key("radius"),
            "the disc of this radius around a tip is smaller than an element; allowed: a larger radius, or a "
            "finer mesh");
    }
    if (tips == 0)
      throw InputError(at, at.key("tips"),
                       "none of these ends lies inside the body; allowed: growth of a crack with a tip, and tips that "
                       "name it");
  }
}

}  // namespace cleft::problem
