// What the hats of mortar contact keep when cracks have grown.
#pragma once

#include "cleft/assembly/state.hpp"

namespace cleft::growth {

/// What hats remember, on a longer crack: tractions are interpolated in arc length, anchors stay where they are, and
/// new faces are at rest. Without the forces.
contact::MultiplierState multipliers_on(const assembly::Model& from, const contact::MultiplierState& memory,
                                        const assembly::Model& to);

/// Writes the tractions that are remembered into the components of all unknowns.
void put_multipliers(const assembly::Model& model, const contact::MultiplierState& memory, VecX& components);

}  // namespace cleft::growth
