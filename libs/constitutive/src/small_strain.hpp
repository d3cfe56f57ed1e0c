/// \file
/// The linearised strain.
#pragma once

#include "cleft/constitutive/plane_tensor.hpp"

namespace cleft::constitutive {

/// sym(H) of a displacement gradient, plane strain.
inline PlaneTensor small_strain(const Mat2& gradient) {
  return plane_tensor(gradient(0, 0), gradient(1, 1), 0.5 * (gradient(0, 1) + gradient(1, 0)), 0.0);
}

}  // namespace cleft::constitutive
