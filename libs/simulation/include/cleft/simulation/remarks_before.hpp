/// \file
/// What a user should know of a problem before it is solved.
#pragma once

#include <string>
#include <vector>

#include "cleft/assembly/model.hpp"
#include "cleft/problem/specification.hpp"

namespace cleft::simulation {

/// What is allowed but may surprise, one line each, with the figure that speaks for it: ends of cracks that were moved
/// or lie close to the boundary, few elements along a crack or in the ball of a tip, no friction, penalties far from
/// E/h, Poisson's ratios at which triangles lock or below 0, displacements that are not zero at load 0, tractions where
/// nothing can move.
std::vector<std::string> remarks_before(const problem::Specification& specification, const assembly::Model& model);

}  // namespace cleft::simulation
