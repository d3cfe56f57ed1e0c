// What cracks that grow have done, in words.
#pragma once

#include <string>
#include <vector>

#include "cleft/growth/evolution.hpp"
#include "cleft/problem/specification.hpp"

namespace cleft::simulation {

/// Of all tips.
long advances_of(const growth::Record& record);

/// One line on an advance at a load: how far, where to, and why no farther.
std::string remark_on(const growth::Advance& advance, const assembly::Model& model, double load);

/// On what cracks that may grow have done: none did, and how near one came; a tip that is hindered; a path that turns
/// to and fro.
std::vector<std::string> remarks_on_growth(const problem::Specification& specification, const growth::Record& record);

}  // namespace cleft::simulation
