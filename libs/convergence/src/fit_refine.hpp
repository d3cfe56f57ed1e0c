// The most probable sequence.
#pragma once

#include "fit_posterior.hpp"

namespace cleft::convergence {

/// Refines the best draw of a posterior: least squares of limit, factor, order and pre-asymptotic terms, weighted as it
/// assumes, its deviations kept.
Draw most_probable(const Sequence& sequence, const Posterior& posterior);

}  // namespace cleft::convergence
