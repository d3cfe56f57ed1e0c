// Contact states handed on to faces that are cut anew.
#pragma once

#include <limits>

#include "cleft/assembly/model.hpp"

namespace cleft::growth {

/// Arc lengths of a crack at which its faces are the same before and after. Where an end has moved that is as far as
/// the crack was drawn: its cut may have ended beyond, on the way to the next element edge, and the longer crack may
/// take another way from there.
struct Kept {
  double first = -std::numeric_limits<double>::infinity(), last = std::numeric_limits<double>::infinity();
  bool holds(double s) const { return first <= s && s <= last; }
};

/// Arc length at a place of a face, 0 to 1, and the place at an arc length.
inline double at(const enrichment::Face& face, double place) {
  return face.s_start + place * (face.s_end - face.s_start);
}
inline double place_on(const enrichment::Face& face, double s) {
  return (s - face.s_start) / (face.s_end - face.s_start);
}

/// Per crack.
std::vector<Kept> kept_parts(const assembly::Model& from, const assembly::Model& to);

/// Memory of the contact points of `to` from that of the points of `from`, whose cracks are the same or shorter.
std::vector<contact::ContactState> contact_on(const assembly::Model& from,
                                              const std::vector<contact::ContactState>& past,
                                              const assembly::Model& to);

}  // namespace cleft::growth
