// The multipliers of mortar contact handed on to cracks that have grown.
#pragma once

#include "cleft/assembly/state.hpp"

namespace cleft::growth {

/// State of the multipliers on a longer crack: tractions are interpolated in arc length, anchors stay where they are,
/// and new faces are at rest. Without the forces.
contact::MultiplierState multipliers_on(const assembly::Model& from, const contact::MultiplierState& past,
                                        const assembly::Model& to);

/// Writes the tractions that are remembered into the components of all unknowns.
void put_multipliers(const assembly::Model& model, const contact::MultiplierState& past, VecX& components);

}  // namespace cleft::growth
