// What contact points, multipliers and cells do from one iterate to the next.
#pragma once

#include <cstdint>
#include <vector>

#include "cleft/solve/newton.hpp"

namespace cleft::solve {

/// The active set of an iteration: partners and status of the contact points, state of the multipliers, cells that
/// flow.
class ActiveSet {
 public:
  /// Takes what the assembler found at an iterate, counts what differs from the one before, and tells whether an
  /// iterate of this increment, not the last one, had the same set: then the iteration goes round in circles.
  bool update(const assembly::Model& model, const assembly::Assembler& assembler, const assembly::History& history,
              const VecX& displacement, Iteration& out);
  /// Whether a multiplier of mortar contact is among what differed.
  bool multipliers_change() const { return multiplier_changes_ > 0; }

 private:
  void points(const assembly::Model& model, const assembly::Assembler& assembler, Iteration& out);
  void multipliers(const assembly::Assembler& assembler, Iteration& out);
  void cells(const assembly::Assembler& assembler, const assembly::History& history, Iteration& out);
  void branches(const assembly::Model& model, const assembly::Assembler& assembler, const VecX& displacement,
                Iteration& out);

  std::vector<Index> partner_, status_, multiplier_status_, flows_;
  std::vector<Index> branches_;  // of the return map: 0 elastic, 1 cone, 2 apex
  int multiplier_changes_ = 0;
  std::vector<std::uint64_t> met_;  // hashes of the sets so far
};

}  // namespace cleft::solve
