// The path of solutions, for bodies whose load must fall before it can rise.
#pragma once

#include <cstdint>

#include "cleft/assembly/model.hpp"
#include "cleft/assembly/state.hpp"

namespace cleft::solve {

/// Along the path: the least length of an increment, over the longest so far.
inline constexpr double kShortest = 1.0 / 4096;
/// The most, over the last increment where that was short to end at a load to hit.
inline constexpr double kLongest = 1e4;

/// State::progress for the increment from `before` to a displacement and the plastic states there:
///
///     w . v = sum_p c_p D_p : grad v / sum_p c_p D_p : D_p,   D_p = grad(increment),
///
/// over the material points p, with c_p the volume times the increment of the plastic multiplier, or the volume where
/// nothing flowed. So it measures the deformation of what flows, which goes on while the rest of the body unloads.
/// Empty if the body has not moved.
VecX path_progress(const assembly::Model& model, const assembly::State& before, const VecX& displacement,
                   const std::vector<constitutive::PlasticState>& plastic);

/// The sign of the tangent matrix's determinant, where it is known.
enum class Determinant : std::uint8_t { Positive, NegativeOrUnknown };

/// The largest displacement of the last increment, metres.
double last_motion(const assembly::Model& model, const assembly::State& state);

/// Part of the energy that changes its kind in an increment, but the first, which the energies leave unexplained; 0
/// where it is below `least` (J/m, rounding) or 2e-3 of the largest energy. What the body gives away in a jump from one
/// branch of solutions to another is no work of any force: there 0.3 and more are seen, in increments that are merely
/// long 0.1, and more where contact begins or turns within them.
double unexplained_part(const assembly::Energies& before, const assembly::Energies& after, double least);

/// Whether an increment of a body that has flowed before unloads it elastically: the load falls, nothing flows, and the
/// determinant of the tangent matrix is positive, as where the body is stable (or has lost its stability twice).
/// Beyond a limit load such a way back is always open, and is not the path that led there.
bool unloads_elastically(const assembly::State& before, const std::vector<constitutive::PlasticState>& plastic,
                         double load, Determinant determinant);

}  // namespace cleft::solve
