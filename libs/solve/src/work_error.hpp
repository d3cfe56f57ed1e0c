// What the external work of an increment misses because the increment is finite.
#pragma once

#include "cleft/assembly/model.hpp"
#include "cleft/assembly/state.hpp"

namespace cleft::solve {

/// Error of the trapezoidal rule, J/m, for the work of reactions and dead loads from `before` to `after`, by how far
/// forces and displacements bend away from where they went in the increment that led to `before`. No amplitude may turn
/// at `before`. 0 if no increment of the load led there.
double trapezoidal_error(const assembly::Model& model, const std::vector<assembly::Constraint>& constraints,
                         const assembly::State& before, const assembly::State& after);

}  // namespace cleft::solve
