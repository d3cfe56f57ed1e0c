/// \file
/// How far solutions of one problem are from each other.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "cleft/objectivity/solution.hpp"

namespace cleft::objectivity {

/// One quantity of several solutions: the difference of each two, relative. NaN where there is nothing to compare, as
/// the pressure of an open crack.
struct Difference {
  std::string quantity;
  /// False for what is told only: the pressure with the ends of the contact, and the energy of penalties or mortar
  /// constraints, which is of the method and not of the body.
  bool judged = true;
  std::vector<double> of_pair;
  std::string doubt;  ///< why it cannot be told: a face with fewer than two contact points apart; else empty

  double largest() const;  ///< NaN if any is
};

/// A part of the contact, from the first to the last point that presses: fractions of its current length.
using ContactPart = std::array<double, 2>;

/// All pairs of `count` solutions: (0, 1), (0, 2), (1, 2), ...
std::vector<std::pair<std::size_t, std::size_t>> pairs_of(std::size_t count);

/// In the order of `pairs_of`, and relative to:
///
/// | quantity | is relative to |
/// | --- | --- |
/// | `reaction NAME`, a vector | the largest reaction |
/// | each energy | its own larger value, at least a thousandth of the largest energy |
/// | `pressure NAME`, L2 over the current place, with the ends of the contact | the larger of the two norms |
/// | `pressure NAME, A to B`, the same over a part of the contact | the larger of the two norms |
///
/// Each face is compared with each of the other solution, like with like where both have points on both faces; what
/// differs more counts. At its corner with the body's surface and at
/// a tip the pressure is singular and its norm hardly exists, so that only the part without the ends is judged.
std::vector<Difference> differences(std::span<const Solution> solutions, const ContactPart& part);

/// Pressure over the current place, for all faces of all solutions over the same curve: the first face
/// that has two points apart. None if no face has.
struct PressureProfile {
  std::size_t solution = 0;
  std::string face;  ///< left or right
  convergence::Curve curve;
};
std::vector<PressureProfile> pressure_profiles(std::span<const Solution> solutions, const std::string& crack);

/// From the first to the last place where any of them presses, as far as all of them have points, metres; none on an
/// open crack.
std::optional<std::array<double, 2>> contact_range(std::span<const PressureProfile> profiles);

}  // namespace cleft::objectivity
