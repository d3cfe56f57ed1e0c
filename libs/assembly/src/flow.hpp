// How far a body flows in one increment.
#pragma once

#include "cleft/assembly/model.hpp"

namespace cleft::assembly {

/// Whether a cell flows farther than its law is integrated well for: the return map takes the direction of flow at the
/// end for that of the whole increment. Too long an increment flows too easily, and a run of them comes to a limit load
/// that the body does not have. Points of branch functions do not count: at a tip they flow without limit.
bool flows_far(const Model& model, const std::vector<constitutive::PlasticState>& before,
               const std::vector<constitutive::PlasticState>& now);

}  // namespace cleft::assembly
