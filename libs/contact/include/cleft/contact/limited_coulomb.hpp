/// \file
/// Friction that is Coulomb's at a small pressure, and no more than a limit at a large one.
#pragma once

#include <cmath>

#include "cleft/contact/strength.hpp"

namespace cleft::contact {

/// strength = limit (1 - exp(-mu p / limit)): the asperities shear off, as those of metals do (Orowan's limit, with a
/// smooth passage). The slope is mu at p = 0.
struct LimitedCoulomb {
  double friction = 0.0;  ///< mu at a small pressure
  double limit = 0.0;     ///< strength at a large pressure, Pa; greater than 0

  Strength strength(double pressure, const InterfaceState& /*begin*/) const {
    if (pressure <= 0.0) return {friction * pressure, friction};
    const double left = std::exp(-friction * pressure / limit);
    return {limit * (1.0 - left), friction * left};
  }
};

}  // namespace cleft::contact
