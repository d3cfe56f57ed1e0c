#include "active_set.hpp"

#include <algorithm>

#include "flow.hpp"

namespace cleft::solve {
namespace {

Index state_of(const contact::NodeState& node) {
  return 4 * static_cast<Index>(node.status) + (node.slides > 0.0 ? 1 : 0) + (node.supported ? 2 : 0);
}

// FNV-1a
std::uint64_t hash(std::uint64_t seed, const std::vector<Index>& values) {
  for (const Index value : values) seed = (seed ^ static_cast<std::uint64_t>(value)) * 1099511628211ULL;
  return seed;
}

// Takes over `count` values and returns how many differ from those before; the first time none does.
template <class Value>
int replace(std::vector<Index>& last, std::size_t count, Value value) {
  const bool first = last.size() != count;
  last.resize(count, kNone);
  int changes = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const Index now = value(k);
    changes += !first && last[k] != now;
    last[k] = now;
  }
  return changes;
}

}  // namespace

// Points of mortar contact only show what its multipliers do; their partners may change without a kink.
void ActiveSet::points(const assembly::Model& model, const assembly::Assembler& assembler, Iteration& out) {
  const auto& pairs = assembler.pairs();
  const auto counts = [&](std::size_t p) {
    return !model.surfaces.is_mortar(model.surfaces.faces[model.surfaces.points[p].face].crack);
  };
  out.partner_changes +=
      replace(partner_, pairs.size(), [&](std::size_t p) { return counts(p) ? pairs[p].partner_face : kNone; });
  out.status_changes += replace(status_, pairs.size(), [&](std::size_t p) {
    return counts(p) ? static_cast<Index>(pairs[p].state.traction.status) : kNone;
  });
}

void ActiveSet::multipliers(const assembly::Assembler& assembler, Iteration& out) {
  const auto& nodes = assembler.multipliers().nodes();
  multiplier_changes_ = replace(multiplier_status_, nodes.size(), [&](std::size_t i) { return state_of(nodes[i]); });
  out.status_changes += multiplier_changes_;
}

void ActiveSet::cells(const assembly::Assembler& assembler, const assembly::History& history, Iteration& out) {
  const auto& plastic = assembler.plastic();
  out.status_changes += replace(flows_, plastic.size(), [&](std::size_t c) {
    return static_cast<Index>(plastic[c].accumulated > history.plastic[c].accumulated);
  });
}

// The apex plays no part in the iteration's course, but its tangent kinks there.
void ActiveSet::branches(const assembly::Model& model, const assembly::Assembler& assembler, const VecX& displacement,
                         Iteration& out) {
  const auto& plastic = assembler.plastic();
  out.flow_changes += replace(branches_, plastic.size(), [&](std::size_t c) {
    const auto point = static_cast<Index>(c);
    return flows_[c] == 0 ? 0 : 1 + static_cast<Index>(is_on_apex(model, point, displacement, plastic[c]));
  });
}

bool ActiveSet::update(const assembly::Model& model, const assembly::Assembler& assembler,
                       const assembly::History& history, const VecX& displacement, Iteration& out) {
  points(model, assembler, out);
  multipliers(assembler, out);
  cells(assembler, history, out);
  branches(model, assembler, displacement, out);
  const std::uint64_t now =
      hash(hash(hash(hash(14695981039346656037ULL, partner_), status_), multiplier_status_), flows_);
  const bool same = !met_.empty() && met_.back() == now;
  const bool again = !same && std::find(met_.begin(), met_.end(), now) != met_.end();
  if (!same) met_.push_back(now);
  return again;
}

}  // namespace cleft::solve
