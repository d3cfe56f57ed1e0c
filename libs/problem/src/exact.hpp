// Exact solutions of scenes.
#pragma once

#include "cleft/assembly/model.hpp"
#include "cleft/problem/field.hpp"

namespace cleft::problem {

/// Adds the dead loads that make a field, times the load, a solution of the model (see FieldLoads).
void add_loads_of(const FieldSpec& spec, assembly::Model& model);

}  // namespace cleft::problem
