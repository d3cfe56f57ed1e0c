/// \file
/// Failures in words. `model` is the one on which they happened, or that on which cracks began to grow into it.
#pragma once

#include <string>

#include "cleft/assembly/failure.hpp"

namespace cleft::simulation {

/// One sentence: what happened, where, and at which load.
std::string describe(const assembly::Failure& failure, const assembly::Model& model);

/// What a user may try, with the keys of a scene that it takes.
std::string advice(const assembly::Failure& failure, const assembly::Model& model);

}  // namespace cleft::simulation
