// Stress intensity factors of the tips for which a scene asks.
#pragma once

#include <string>
#include <vector>

#include "cleft/assembly/stepping.hpp"
#include "cleft/enrichment/sif.hpp"

namespace cleft::scene {

/// The columns of a crack, in the order of intensities_of: at its first and at its last point K_I and K_II by the
/// interaction integral, and by the opening and the slip of the faces.
std::vector<std::string> intensity_columns(const std::string& crack);

/// Stress intensity factors of a crack's tips at the last converged state, Pa m^(1/2); NaN at a mouth. K_II is positive
/// where the face to the left, seen from the crack along its continuation, moves ahead. By the faces: K(r) = E' jump /
/// 8 sqrt(2 pi / r) over the inner part of the ball, continued linearly to r = 0. Both are those of small strain.
std::vector<double> intensities_of(const assembly::LoadStepper& stepper, Index crack);

}  // namespace cleft::scene
