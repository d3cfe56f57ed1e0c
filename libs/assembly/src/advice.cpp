#include "cleft/assembly/advice.hpp"

namespace cleft::assembly {

bool has_springs(const Model& model) {
  for (Index crack = 0; crack < static_cast<Index>(model.surfaces.laws.size()); ++crack)
    if (!model.surfaces.is_mortar(crack)) return true;
  return false;
}

std::string softer(const Model& model, const char* where) {
  std::string out = "smaller increments (loading.steps), ";
  if (has_springs(model)) out += "a softer penalty, ";
  // on a crack with a step across its way smoothing 1, 2, 4 and 8 take 75, 69, 66 and 64 iterations
  if (!model.surfaces.hats.nodes.empty()) out += "more smoothing of mortar contact (contact.smoothing), ";
  return out + "or a finer mesh" + where;
}

}  // namespace cleft::assembly
