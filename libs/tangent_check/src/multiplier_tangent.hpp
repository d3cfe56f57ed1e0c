// The tangents of mortar contact: forces of the multipliers, and the conditions of their nodes.
#pragma once

#include "cleft/tangent_check/tangent.hpp"
#include "force_nearby.hpp"

namespace cleft::tangent_check {

/// Compares the faces without the body, so that every force and condition is one of contact; sums up the forces as one
/// block, and the conditions by those that their nodes have.
void check_multipliers(const CheckedState& at, const GlobalSteps& steps, double tolerance, TangentReport& report);

}  // namespace cleft::tangent_check
