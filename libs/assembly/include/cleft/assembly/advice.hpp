// What to try where an increment fails, as the model has it.
#pragma once

#include <string>

#include "cleft/assembly/model.hpp"

namespace cleft::assembly {

/// Whether springs hold the faces of some crack apart.
bool has_springs(const Model& model);

/// Smaller increments, softer contact as the method of each crack has it, a finer mesh (" there", " at the crack").
std::string softer(const Model& model, const char* where);

}  // namespace cleft::assembly
