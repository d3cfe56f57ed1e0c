// Plastic and elastic histories of F-bar bodies, whose cells have other partners once a crack has grown.
#pragma once

#include "cleft/assembly/model.hpp"

namespace cleft::growth {

/// Histories with the elastic volume, negative, in the place of the plastic one; without patches as they are.
std::vector<constitutive::PlasticState> without_volume(const assembly::Model& model, const VecX& displacement,
                                                       std::vector<constitutive::PlasticState> plastic);

/// Back, theory (10.11): both cells of a patch have one plastic volume, and the elastic one is the mean of theirs. What
/// has not flowed has no plastic strain.
std::vector<constitutive::PlasticState> with_volume(const assembly::Model& model, const VecX& displacement,
                                                    std::vector<constitutive::PlasticState> plastic);

}  // namespace cleft::growth
