// On which smooth branch of the contact law a point stands.
#pragma once

#include <array>
#include <vector>

#include "cleft/assembly/model.hpp"
#include "cleft/contact/multipliers.hpp"

namespace cleft::tangent_check {

/// Why the force of a contact point is not differentiable between two of its states: what changes from one to the
/// other. Null if nothing does.
const char* kink_between(const contact::Pair& a, const contact::Pair& b);

/// Whether a contact point only shows the tractions of its crack's multipliers.
inline bool is_mortar(const assembly::Model& model, Index point) {
  return model.surfaces.is_mortar(model.surfaces.faces[model.surfaces.points[point].face].crack);
}

/// What block_of calls contact points and nodes of multipliers.
inline constexpr const char* kAtMouth = "contact at a mouth";
inline constexpr std::array kPointBranches{"contact open", "contact stick", "contact slip", "contact first touch"};
inline constexpr const char* kMultiplierForces = "multiplier forces";
inline constexpr std::array kMultiplierBranches{kMultiplierForces, "multiplier open", "multiplier stick",
                                                "multiplier slip", "multiplier leaning"};

/// "contact stick" and the like.
const char* block_of(const contact::Pair& pair, const contact::ContactState& past);

/// "multiplier stick" and the like.
const char* block_of(const contact::NodeState& node);

/// Adds the unknowns in whose rows the multipliers' tractions or conditions are not differentiable between two states.
void add_kinks(const assembly::Model& model, const contact::Multipliers& a, const contact::Multipliers& b,
               std::vector<Index>& out);

/// Unknowns on which the force of a point may depend; the first `forces` of them are those on which it acts.
struct PairUnknowns {
  std::vector<Index> all;
  std::size_t forces = 0;
};
PairUnknowns unknowns_of(const assembly::Model& model, Index point, const contact::Pair& pair,
                         const contact::ContactState& past);

}  // namespace cleft::tangent_check
