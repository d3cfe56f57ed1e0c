// Loads that do not follow the body.
#pragma once

#include "cleft/assembly/model.hpp"
#include "cleft/problem/specification.hpp"

namespace cleft::problem {

/// Adds tractions, gravity and what keeps a manufactured solution in equilibrium. The faces and the unknowns of the
/// model are there. Throws InputError where a boundary does not exist, and where one with a traction meets the ball of
/// a tip.
void add_dead_loads(const Specification& specification, assembly::Model& model);

}  // namespace cleft::problem
