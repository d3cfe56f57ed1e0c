// Contact memory handed on to faces that are cut anew.
#pragma once

#include "cleft/assembly/model.hpp"

namespace cleft::growth {

/// Memory of the contact points of `to` from that of the points of `from`, whose cracks are the same or shorter.
std::vector<contact::Memory> contact_on(const assembly::Model& from, const std::vector<contact::Memory>& memory,
                                        const assembly::Model& to);

}  // namespace cleft::growth
