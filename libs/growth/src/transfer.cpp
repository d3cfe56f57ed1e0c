#include "cleft/growth/transfer.hpp"

#include <algorithm>

#include "contact_transfer.hpp"
#include "f_bar_transfer.hpp"
#include "multiplier_transfer.hpp"
#include "plastic_transfer.hpp"

namespace cleft::growth {
namespace {

using assembly::Model, assembly::State;

// The unknown of `from` that an unknown of `to` takes its value from, or kNone.
std::vector<Index> sources(const Model& from, const Model& to) {
  std::vector<Index> source(to.unknowns.count, kNone);
  for (Index k = 0; k < to.unknowns.first_amplitude; ++k) {
    const Index node = to.unknowns.node_of[k], ghost = from.unknowns.ghost[node];
    source[k] = k < to.unknowns.nodes || ghost == kNone ? node : ghost;
  }
  for (Index t = 0; t < static_cast<Index>(to.cut.tips.size()); ++t) {
    const auto& ball = to.cut.tips[t];
    const auto same = std::ranges::find_if(from.cut.tips, [&](const geometry::TipBall& old) {
      return old.crack == ball.crack && old.end == ball.end && old.frame.tip() == ball.frame.tip();
    });
    if (same == from.cut.tips.end()) continue;
    const auto old = static_cast<Index>(same - from.cut.tips.begin());
    for (int a = 0; a < enrichment::kBranches; ++a)
      source[to.unknowns.amplitude(t, a)] = from.unknowns.amplitude(old, a);
  }
  return source;
}

VecX displacement_on(const Model& from, const VecX& u, const Model& to) {
  VecX out = VecX::Zero(to.unknowns.components());
  const auto source = sources(from, to);
  for (std::size_t k = 0; k < source.size(); ++k)
    if (source[k] != kNone) out.segment<2>(2 * static_cast<Index>(k)) = u.segment<2>(2 * source[k]);
  return out;
}

// A new ghost has had no force of its own so far.
VecX prescribed_force_on(const Model& from, const VecX& force, const Model& to) {
  VecX full = VecX::Zero(from.unknowns.components());
  const auto old = assembly::constraints_of(from), now = assembly::constraints_of(to);
  for (std::size_t k = 0; k < old.size(); ++k) full[old[k].component] = force[static_cast<Index>(k)];
  VecX out = VecX::Zero(static_cast<Index>(now.size()));
  for (std::size_t k = 0; k < now.size(); ++k) {
    const Index unknown = now[k].component / 2, node = to.unknowns.node_of[unknown];
    const Index source = unknown < to.unknowns.nodes ? unknown : from.unknowns.ghost[node];
    if (source != kNone) out[static_cast<Index>(k)] = full[2 * source + now[k].component % 2];
  }
  return out;
}

}  // namespace

State transfer(const Model& from, const State& state, const Model& to) {
  State out = state;
  out.history.multipliers = multipliers_on(from, state.history.multipliers, to);
  out.displacement = displacement_on(from, state.displacement, to);
  put_multipliers(to, out.history.multipliers, out.displacement);
  out.previous_displacement = out.displacement;
  out.previous_load = state.load;
  out.progress.resize(0);
  out.prescribed_force = prescribed_force_on(from, state.prescribed_force, to);
  out.previous_prescribed_force = out.prescribed_force;
  const auto before = without_volume(from, state.displacement, state.history.plastic);
  out.history.plastic = with_volume(to, out.displacement, plastic_on(from, before, to));
  out.history.contact = contact_on(from, state.history.contact, to);
  return out;
}

}  // namespace cleft::growth
