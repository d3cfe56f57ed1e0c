// Prescribed displacements.
#pragma once

#include "cleft/assembly/model.hpp"
#include "cleft/problem/specification.hpp"

namespace cleft::problem {

/// Binds the prescribed displacements to the unknowns of a model in the coordinates of its mesh. Throws InputError
/// where a boundary holds no node, where two contradict each other at a node, and where together they leave a rigid
/// motion.
void prescribe(const Specification& specification, assembly::Model& model);

/// The sides of a field are those of a crack along its direction; a crack that runs the other way would swap them.
/// Throws InputError.
void refuse_reversed_cracks(const FieldSpec& spec, const std::vector<geometry::Crack>& cracks);

}  // namespace cleft::problem
