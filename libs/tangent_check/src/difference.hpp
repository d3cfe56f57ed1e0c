// Difference quotients of forces, their steps, and how far they are to be trusted.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "cleft/assembly/model.hpp"
#include "cleft/tangent_check/tangent.hpp"

namespace cleft::tangent_check {

/// Lengths from which steps follow, metres, and stiffnesses from which rounding does.
struct Lengths {
  std::vector<double> influence;  ///< per unknown: over which its weight falls from one to nothing
  std::vector<double> stiffness;  ///< per unknown: what an elastic point sets against it, the largest, N/m^2
  double reach = 0.0;             ///< largest coordinate: positions carry its rounding
};
Lengths lengths_of(const assembly::Model& model, const VecX& u);

/// The step at which truncation and rounding of a central difference balance, rounded to a power of two so that it is
/// added without rounding.
double first_step(double influence, double reach);

/// The step below which the rounding of positions hides differences of the relative size `tolerance`.
double least_step(double reach, double tolerance);

/// The derivative, and how far apart the central differences of the steps h and 2 h lie.
struct Quotient {
  double value = 0.0;
  double uncertainty = std::numeric_limits<double>::infinity();
};

/// At which multiples of the step a force is needed.
inline constexpr std::array<double, 4> kOffsets{-2.0, -1.0, 1.0, 2.0};

/// From the forces at kOffsets.
Quotient quotient(const std::array<double, 4>& force, double step);

/// Whether a quotient can tell an entry that is wrong by `tolerance` of `scale`, the largest one of its row. A row of
/// which the tangent knows nothing is measured by the difference itself.
inline bool is_certain(const Quotient& q, double scale, double tolerance) {
  return q.uncertainty <= 0.25 * tolerance * std::fmax(scale, std::fabs(q.value));
}

/// Rows of which little is left, where the forces of two faces cancel or perfect flow bears no more, are rounding: this
/// part of the largest entry of contact, or of the stiffness of an elastic body, is their least scale.
inline constexpr double kFaint = 1e-3;

/// Why a part is listed some of whose entries are left out.
inline constexpr const char* kUnclear = "two sizes of the step disagree";

/// Adds an entry, complete but for its difference, to its block; false if the difference is too uncertain to judge it.
bool count(TangentBlock& block, TangentEntry entry, const Quotient& difference, double tolerance);

}  // namespace cleft::tangent_check
