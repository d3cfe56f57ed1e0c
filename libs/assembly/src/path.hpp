// The path of solutions, for bodies whose load must fall before it can rise.
#pragma once

#include "cleft/assembly/model.hpp"
#include "cleft/assembly/state.hpp"

namespace cleft::assembly {

/// State::progress for the increment from `before` to a displacement and the plastic states there:
///
///     w . v = sum_p c_p D_p : grad v / sum_p c_p D_p : D_p,   D_p = grad(increment),
///
/// over the material points p, with c_p the volume times the increment of the plastic multiplier, or the volume where
/// nothing flowed. So it measures the deformation of what flows, which goes on while the rest of the body unloads.
/// Empty if the body has not moved.
VecX path_progress(const Model& model, const State& before, const VecX& displacement,
                   const std::vector<constitutive::PlasticState>& plastic);

/// The largest displacement of the last increment, metres.
double last_motion(const Model& model, const State& state);

/// Whether the energies leave so much of an increment unexplained that it has jumped from one branch of solutions to
/// another: what the body gives away in a jump is no work of any force.
bool has_jumped(const Energies& before, const Energies& after);

/// Whether an increment of a body that has flowed before unloads it elastically: the load falls, nothing flows, and the
/// equilibrium is stable. Beyond a limit load such a way back is always open, and is not the path that led there.
bool unloads_elastically(const State& before, const std::vector<constitutive::PlasticState>& plastic, double load,
                         bool stable);

}  // namespace cleft::assembly
