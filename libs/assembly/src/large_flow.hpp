// Increments over which a body flows farther than they can follow.
#pragma once

#include <optional>

#include "cleft/assembly/failure.hpp"
#include "cleft/assembly/model.hpp"

namespace cleft::assembly {

/// A failure where a material point flows by more in one increment than its law is integrated for: the return map takes
/// the direction of flow at the end for that of the whole increment. Too long increments flow too easily, and a body
/// comes to a limit load that it does not have.
std::optional<Failure> large_flow(const Model& model, const std::vector<constitutive::PlasticState>& before,
                                  const std::vector<constitutive::PlasticState>& now);

}  // namespace cleft::assembly
