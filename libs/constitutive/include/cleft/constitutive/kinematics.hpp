/// \file
/// Which laws are of small strain, and what that makes them be asked at.
#pragma once

#include "cleft/constitutive/linear_elastic.hpp"
#include "cleft/constitutive/plastic.hpp"

namespace cleft::constitutive {

/// Whether a law takes the linearised strain and answers with the Cauchy stress. It is asked at the displacement
/// gradient H = F - 1, any, where the others are asked at F: of a strain of 1e-14 the 1 in F would leave two digits.
template <class Law>
inline constexpr bool kIsSmallStrain = std::is_same_v<Law, LinearElastic> || std::is_same_v<Law, SmallPlastic>;

/// What a law is asked at where the displacement gradient is H.
template <class Law>
Mat2 argument_of(const Mat2& displacement_gradient) {
  if constexpr (kIsSmallStrain<Law>) return displacement_gradient;
  return Mat2::Identity() + displacement_gradient;
}

}  // namespace cleft::constitutive
