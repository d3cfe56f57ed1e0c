// The coordinate along the path of solutions, for bodies whose load must fall before it can rise.
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

}  // namespace cleft::assembly
