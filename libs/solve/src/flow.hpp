// How far a body flows in one increment.
#pragma once

#include "cleft/assembly/model.hpp"

namespace cleft::solve {

/// The most that a cell flows by in an increment, as growth of its plastic multiplier. Points of branch functions do
/// not count: at a tip they flow without limit.
double largest_flow(const assembly::Model& model, const std::vector<constitutive::PlasticState>& before,
                    const std::vector<constitutive::PlasticState>& now);

/// Whether a material point that flows has returned to the apex of its cone, by its state at the end of the increment.
bool is_on_apex(const assembly::Model& model, Index point, const VecX& displacement,
                const constitutive::PlasticState& now);

}  // namespace cleft::solve
