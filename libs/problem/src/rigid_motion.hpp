// Whether the prescribed displacements hold the body.
#pragma once

#include <optional>
#include <string>

#include "cleft/assembly/model.hpp"

namespace cleft::problem {

/// The rigid motion that the boundaries leave to a part of the body, in words; nothing if every part is held. Parts
/// that a crack separates may hold each other by contact: here they count as one, so that what is named is free
/// whatever the contact does.
std::optional<std::string> free_motion(const assembly::Model& model);

}  // namespace cleft::problem
