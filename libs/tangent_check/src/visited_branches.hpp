// Which branches of the laws a state stands on.
#pragma once

#include "cleft/tangent_check/tangent.hpp"
#include "force_nearby.hpp"

namespace cleft::tangent_check {

/// Branches that a state stands on: names of blocks without sides. `assembler`: as it has assembled the state.
BranchNames branches_at(const CheckedState& at, const assembly::Assembler& assembler);

}  // namespace cleft::tangent_check
