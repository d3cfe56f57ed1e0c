// Names of places for messages.
#pragma once

#include <string>

#include "cleft/assembly/model.hpp"

namespace cleft::assembly {

/// The unknown of a component: node, coordinates and, near a crack, the side.
std::string place_of(const Model& model, Index component);

}  // namespace cleft::assembly
