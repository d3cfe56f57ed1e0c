// Plastic histories handed on to the parts that a longer crack leaves of each triangle.
#pragma once

#include "cleft/assembly/model.hpp"

namespace cleft::growth {

/// The histories of `from`, one a material point, on `to`: theory (10.10). Empty if there are none.
std::vector<constitutive::PlasticState> plastic_on(const assembly::Model& from,
                                                   const std::vector<constitutive::PlasticState>& plastic,
                                                   const assembly::Model& to);

}  // namespace cleft::growth
