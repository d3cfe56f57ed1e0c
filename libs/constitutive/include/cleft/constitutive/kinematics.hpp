/// \file
/// Which laws are of small strain.
#pragma once

#include "cleft/constitutive/linear_elastic.hpp"
#include "cleft/constitutive/plastic.hpp"

namespace cleft::constitutive {

/// Whether a law takes sym(F) - 1 for the strain and answers with the Cauchy stress, for any F.
template <class Law>
inline constexpr bool kIsSmallStrain = std::is_same_v<Law, LinearElastic> || std::is_same_v<Law, SmallPlastic>;

}  // namespace cleft::constitutive
