// Faces that have gone through each other without a contact point noticing.
#pragma once

#include <optional>

#include "cleft/assembly/failure.hpp"
#include "cleft/assembly/state.hpp"
#include "cleft/contact/search.hpp"

namespace cleft::solve {

/// Looks farther than the search did for the partners of points that pressed in the last converged state (`before`;
/// none there: at rest, where all touch) and have none now. A partner there that the point has passed is a failure: the
/// body is penetrated deeper than the search radius.
std::optional<assembly::Failure> tunnelling(const assembly::Model& model, const assembly::History& history,
                                            const VecX& displacement, const std::vector<contact::Pair>& before,
                                            const std::vector<contact::Pair>& now);

}  // namespace cleft::solve
