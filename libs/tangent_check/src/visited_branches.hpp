// Which branches of the laws a scene has, and which of them a state stands on.
#pragma once

#include <set>
#include <string>

#include "force_nearby.hpp"

namespace cleft::tangent_check {

/// Names of the blocks of a report, without the side of a crack.
using BranchNames = std::set<std::string>;

/// Those that a body may come to, whatever happens to it.
BranchNames possible_branches(const assembly::Model& model);

/// Those that a state stands on. `assembler`: as it has assembled the state.
BranchNames branches_at(const CheckedState& at, const assembly::Assembler& assembler);

}  // namespace cleft::tangent_check
