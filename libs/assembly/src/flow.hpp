// How far a body flows in one increment.
#pragma once

#include "cleft/assembly/model.hpp"

namespace cleft::assembly {

/// What a cell may flow by in an increment, as growth of its plastic multiplier. The return map takes the direction of
/// flow at the end for that of the whole increment. Too long an increment flows too easily, and a run of them comes to
/// a limit load that the body does not have.
inline constexpr double kFarFlow = 0.1;

/// The most that a cell flows by. Points of branch functions do not count: at a tip they flow without limit.
double largest_flow(const Model& model, const std::vector<constitutive::PlasticState>& before,
                    const std::vector<constitutive::PlasticState>& now);

}  // namespace cleft::assembly
