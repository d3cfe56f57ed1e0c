// The faces of a body without the body.
#pragma once

#include "cleft/assembly/model.hpp"

namespace cleft::tangent_check {

/// All unknowns and faces, and nothing but contact that acts on them.
assembly::Model without_bulk(const assembly::Model& model);

}  // namespace cleft::tangent_check
