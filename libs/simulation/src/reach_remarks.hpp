// How exact the stress intensity factors of a scene can be.
#pragma once

#include <string>
#include <vector>

#include "cleft/assembly/model.hpp"
#include "cleft/problem/specification.hpp"

namespace cleft::simulation {

/// One line for each tip whose intensities may be off by more than 1 % because its ball, or at finite strain its reach,
/// is less than 3 element sizes.
std::vector<std::string> remarks_on_small_reach(const problem::Specification& specification,
                                                const assembly::Model& model);

/// The same, and also for each tip whose reach is less than its ball.
std::vector<std::string> remarks_on_reach(const problem::Specification& specification, const assembly::Model& model);

}  // namespace cleft::simulation
