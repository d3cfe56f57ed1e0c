/// \file
/// What the result files of a specification hold.
#pragma once

#include "cleft/problem/specification.hpp"
#include "cleft/results/contents.hpp"

namespace cleft::simulation {

results::Contents contents_of(const problem::Specification& specification);

}  // namespace cleft::simulation
