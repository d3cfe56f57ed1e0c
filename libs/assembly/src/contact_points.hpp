// What the assembly asks of single points of contact.
#pragma once

#include "cleft/contact/search.hpp"

namespace cleft::assembly {

// Whether the force depends on where the anchor is now, apart from the partner.
inline bool pulls_anchor(const contact::Surfaces& surfaces, const contact::Pair& pair) {
  return pair.state.traction.status == contact::Status::Stick && pair.anchored && !surfaces.undeformed;
}

// Whether a contact point only shows the tractions of its crack's multipliers.
inline bool is_mortar(const contact::Surfaces& surfaces, std::size_t point) {
  return !surfaces.multiplier_space.empty() && surfaces.is_mortar(surfaces.faces[surfaces.points[point].face].crack);
}

}  // namespace cleft::assembly
