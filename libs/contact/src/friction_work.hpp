// Friction of one increment, from what is known at its ends.
#pragma once

#include <algorithm>

namespace cleft::contact {

/// A slide within an increment. Tractions are counted along it.
struct Slide {
  double traction = 0.0;         ///< at the beginning, Pa; where less than the strength the slide begins later
  double strength_before = 0.0;  ///< at the beginning, Pa
  double strength = 0.0;         ///< at the end, Pa; 0 where the faces have parted
  double stiffness = 0.0;        ///< of what holds the faces, Pa/m
  double length = 0.0;           ///< metres, beyond what is elastic; at least 0
};

/// theory (7.8), J/m^2: the strength goes evenly over the increment, and the slide too, once the traction has reached
/// the strength. Exact for a strength that does not change.
inline double friction_of(const Slide& slide) {
  constexpr double kBody = 0.03;  // stiffness of the body that moves the faces, over that of what holds them
  const double below = std::max(0.0, slide.strength_before - slide.traction);
  const double beyond = kBody * slide.stiffness * slide.length;
  const double sticks = below > 0.0 ? below / (below + beyond) : 0.0;
  const double line = slide.strength_before + sticks * (slide.strength - slide.strength_before);
  const double at_onset = std::max(line, std::min(slide.traction, slide.strength_before));
  return 0.5 * (at_onset + slide.strength) * slide.length;
}

/// theory (7.9), J/m^2, of faces that were apart and touch at the end of an increment: the law lets them slide freely
/// until then. When they touched is not known: half of the slide counts, with a strength that rises from 0.
inline double touching_friction_of(double strength, double slide) { return 0.5 * strength * (0.5 * slide); }

}  // namespace cleft::contact
