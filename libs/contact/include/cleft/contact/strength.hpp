/// \file
/// What every interface law gives, and what it remembers.
#pragma once

#include <concepts>

namespace cleft::contact {

/// State of an interface law at a material point. What has converged and the trial of the present iterate are two
/// objects: no law changes the one it reads.
struct InterfaceState {
  double slip = 0.0;  ///< accumulated plastic slip, metres; never decreases
};

/// Strength against sliding, Pa, and how it rises with the pressure.
struct Strength {
  double value = 0.0;
  double by_pressure = 0.0;  ///< d value / d pressure, 1
};

/// An interface law: a plain struct of parameters with the strength at a pressure (Pa, positive where the faces press
/// each other) and at the state at which the increment begins. A negative pressure may occur within an iteration: the
/// law goes on there as the tangent at 0 does, so that the strength is continuous with its derivative.
template <class Law>
concept InterfaceStrength = requires(const Law& law, double pressure, const InterfaceState& begin) {
  { law.strength(pressure, begin) } -> std::same_as<Strength>;
};

}  // namespace cleft::contact
