// The assembled force near a state, and what stands on another branch of its law there.
#pragma once

#include "cleft/assembly/assembler.hpp"
#include "flow_branch.hpp"
#include "global_tangent.hpp"

namespace cleft::tangent_check {

/// Where a tangent is checked.
struct CheckedState {
  const assembly::Model& model;
  const assembly::History& history;
  const VecX& u;  ///< metres, all components
  double load = 0.0;
};

/// Evaluates the force of a model at displacements near a state. A material point, contact point or node of multipliers
/// that has left its branch makes the rows kinked on which it acts.
class ForceNearby {
 public:
  /// `assembler`: as it has assembled the state; it is used for all evaluations.
  ForceNearby(const CheckedState& at, assembly::Assembler& assembler);

  GlobalForce operator()(const VecX& there) const;

 private:
  void add_unknowns_of(Index point, std::vector<Index>& out) const;

  const CheckedState& at_;
  assembly::Assembler& assembler_;
  const std::vector<contact::Pair> pairs_;
  const contact::Multipliers multipliers_;
  const std::vector<FlowBranch> flow_;
};

}  // namespace cleft::tangent_check
