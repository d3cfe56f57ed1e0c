/// \file
/// The interface laws: one file a law, one entry here. Penalty and mortar contact call `strength` and know no law by
/// name.
#pragma once

#include <variant>

#include "cleft/contact/coulomb.hpp"
#include "cleft/contact/limited_coulomb.hpp"

namespace cleft::contact {

using InterfaceLaw = std::variant<Coulomb, LimitedCoulomb>;

/// Strength of the law at hand, see InterfaceStrength.
inline Strength strength(const InterfaceLaw& law, double pressure, const InterfaceState& begin) {
  return std::visit([&]<InterfaceStrength Law>(const Law& l) { return l.strength(pressure, begin); }, law);
}

}  // namespace cleft::contact
