/// \file
/// The linearised strain.
#pragma once

#include "cleft/constitutive/plane_tensor.hpp"

namespace cleft::constitutive {

/// sym(F) - 1, plane strain.
inline PlaneTensor small_strain(const Mat2& deformation) {
  return plane_tensor(deformation(0, 0) - 1.0, deformation(1, 1) - 1.0, 0.5 * (deformation(0, 1) + deformation(1, 0)),
                      0.0);
}

}  // namespace cleft::constitutive
