/// \file
/// When a crack's tip advances, and where to. A criterion is a struct with its parameters (problem/specification.hpp)
/// and one function `judge`; a new one joins the variant there.
#pragma once

#include <array>
#include <limits>
#include <variant>

#include "cleft/assembly/equilibrium.hpp"
#include "cleft/enrichment/sif.hpp"
#include "cleft/problem/specification.hpp"

namespace cleft::growth {

/// A tip by its crack and its end (0 the first, 1 the last point).
struct TipName {
  Index crack = kNone;
  int end = 0;
};

/// What a body asks of a tip.
struct Demand {
  double ratio = 0.0;        ///< over what the material bears: the tip advances at 1; not a number: no answer
  Vec2 ahead{1.0, 0.0};      ///< unit vector, in the reference configuration: the way that it would take
  double stress = kUnknown;  ///< Pa: largest principal value of the mean Cauchy stress (Rankine)
  enrichment::Intensities intensities{kUnknown, kUnknown};  ///< Pa m^(1/2) (maximum hoop stress),
  double elements = kUnknown;  ///< and within how many element sizes of the tip they were taken

  static constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
};

/// The largest principal value of the mean Cauchy stress around the tip reaches a strength (Liu and Borja 2010, (94)).
/// Stress and deformation gradient F are means over the disc of `radius` around the tip in the reference configuration,
/// of every part of a triangle as much as lies within; in the ball of a tip the points of a triangle count as it does.
/// The crack goes on along the line normal to the pulled-back principal direction, N = n . F / |n . F| (93), in the
/// sense that leads ahead.
///
/// Around the tip of a closed, sliding crack the field of mode II has means of zero but for the shear stress, whose
/// principal directions lie at 45 degrees: that is where the crack turns, not the 70.5 degrees of the hoop stress.
///
/// Not a number where the disc around the tip is smaller than an element.
Demand judge(const problem::Rankine& criterion, const assembly::Equilibrium& body, const TipName& tip);

/// The largest hoop stress of the singular field reaches that of mode I at a toughness (Erdogan and Sih 1963):
///
///     cos^2(t/2) [K_I cos(t/2) - 3 K_II sin(t/2)] = K_c,   tan(t/2) = [K_I - sqrt(K_I^2 + 8 K_II^2)] / (4 K_II),
///
/// and the crack turns by t. Intensities are those of the interaction integral. Closed faces bear no K_I below zero.
///
/// The tip must have a ball (geometry::TipBall); intensities are taken within its reach. Not a number where the body
/// ends, or the crack bends, within half an element size.
Demand judge(const problem::HoopStress& criterion, const assembly::Equilibrium& body, const TipName& tip);

/// Angle by which a tip of given intensities turns, radians, to the left; and the intensity of mode I that opens it as
/// much there, Pa m^(1/2).
struct HoopDirection {
  double turn = 0.0;
  double intensity = 0.0;
};
HoopDirection largest_hoop_stress(const enrichment::Intensities& k);

}  // namespace cleft::growth
