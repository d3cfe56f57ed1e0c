/// \file
/// The tangent along a run: at states evenly over the load, and wherever the body comes to a branch of a law on which
/// it has not been judged yet.
#pragma once

#include "cleft/tangent_check/intermediate_states.hpp"
#include "cleft/tangent_check/tangent.hpp"

namespace cleft::tangent_check {

struct SurveyControls {
  int states = 5;           ///< evenly over the load
  double tolerance = 1e-6;  ///< as in check_tangent
};

/// What has been seen so far, and the state that was seen last.
using SurveyObserver = std::function<void(const IntermediateState& last, const TangentReport& report)>;

/// Takes the run to its end. In every increment the remainder of the residual's linearisation is tested, and the state
/// is looked at together with the one that the same step leads to backwards from the last converged state: what slid
/// sticks there, and what flowed is elastic. Where an apex that materials have is not met, chosen states are swollen
/// until it is. Tangents are compared (check_tangent) at `states` of the states evenly over the load, where cracks have
/// grown, where the run fails, where the remainder is of first order, and wherever one of these states stands on a
/// branch of which nothing could be judged so far. Ends early where a tangent is wrong. States without forces are
/// listed among the kinks. Returns the failure of the run.
[[nodiscard]] std::optional<assembly::Failure> survey(growth::Evolution& body, const SurveyControls& controls,
                                                      TangentReport& report, const SurveyObserver& observer);

}  // namespace cleft::tangent_check
