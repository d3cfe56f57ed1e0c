// Which material fills which part of the body.
#pragma once

#include "cleft/assembly/model.hpp"
#include "cleft/problem/specification.hpp"

namespace cleft::problem {

/// Sets the model's materials, by the regions that the scene gives them. The mesh is cut, and the cells are there.
/// Throws InputError, located in the scene, where a region does not exist, where a crack has no sides to tell because
/// it does not divide the body, and where a part of the body has no material or two.
void fill_with_materials(const Specification& specification, assembly::Model& model);

}  // namespace cleft::problem
