// Which branches of the laws a state stands on.
#pragma once

#include "force_nearby.hpp"

namespace cleft::tangent_check {

/// Those that a state stands on. `assembler`: as it has assembled the state.
BranchNames branches_at(const CheckedState& at, const assembly::Assembler& assembler);

}  // namespace cleft::tangent_check
