#include "force_nearby.hpp"

#include <cmath>

#include "branch.hpp"

namespace cleft::tangent_check {

ForceNearby::ForceNearby(const CheckedState& at, assembly::Assembler& assembler)
    : at_(at),
      assembler_(assembler),
      pairs_(assembler.pairs()),
      multipliers_(assembler.multipliers()),
      flow_(flow_branches(at.model, at.history, at.u)) {}

GlobalForce ForceNearby::operator()(const VecX& there) const {
  GlobalForce out;
  if (assembler_.assemble(there, at_.history)) {
    out.force = VecX::Constant(there.size(), std::nan(""));
    return out;
  }
  out.force = assembler_.internal_force();
  add_flow_kinks(at_.model, flow_, flow_branches(at_.model, at_.history, there), out.kinked);
  if (!at_.model.surfaces.multiplier_space.empty())
    add_kinks(at_.model, multipliers_, assembler_.multipliers(), out.kinked);
  for (Index p = 0; p < static_cast<Index>(pairs_.size()); ++p)
    if (!is_mortar(at_.model, p) && kink_between(pairs_[p], assembler_.pairs()[p])) add_unknowns_of(p, out.kinked);
  return out;
}

// Those on which a contact point acts, here or there.
void ForceNearby::add_unknowns_of(Index point, std::vector<Index>& out) const {
  for (const auto* pair : {&pairs_[point], &assembler_.pairs()[point]}) {
    const auto unknowns = unknowns_of(at_.model, point, *pair, at_.history.contact[point]);
    out.insert(out.end(), unknowns.all.begin(), unknowns.all.begin() + static_cast<std::ptrdiff_t>(unknowns.forces));
  }
}

}  // namespace cleft::tangent_check
