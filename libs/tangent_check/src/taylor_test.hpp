// The remainder of the residual's linearisation, all rows at once.
#pragma once

#include "cleft/tangent_check/tangent.hpp"
#include "force_nearby.hpp"

namespace cleft::tangent_check {

/// Adds the state to the test: a few evaluations of the force, along one direction that moves every unknown.
/// `assembler`: as it has assembled the state. False if the remainder has a part of first order that is larger than
/// `tolerance` of the force's change.
bool test_remainder(const CheckedState& at, double tolerance, assembly::Assembler& assembler, TaylorTest& out);

}  // namespace cleft::tangent_check
