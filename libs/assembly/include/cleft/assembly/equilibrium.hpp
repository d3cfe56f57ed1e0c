/// \file
/// A body in equilibrium, for those who look at it.
#pragma once

#include "cleft/assembly/model.hpp"
#include "cleft/contact/search.hpp"

namespace cleft::assembly {

/// What an increment has converged to, whether it is kept or not. Refers to what others own.
struct Equilibrium {
  const Model& model;
  double load;
  const VecX& displacement;                                ///< metres, all components
  const std::vector<constitutive::PlasticState>& plastic;  ///< per material point; empty without memory
  const std::vector<contact::Pair>& pairs;                 ///< per contact point
};

}  // namespace cleft::assembly
