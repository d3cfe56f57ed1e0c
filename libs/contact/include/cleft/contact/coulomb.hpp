/// \file
/// Coulomb's friction.
#pragma once

#include "cleft/contact/strength.hpp"

namespace cleft::contact {

/// strength = mu p (Liu and Borja 2010, (59)).
struct Coulomb {
  double friction = 0.0;  ///< Coulomb's coefficient mu

  Strength strength(double pressure, const InterfaceState& /*begin*/) const { return {friction * pressure, friction}; }
};

}  // namespace cleft::contact
