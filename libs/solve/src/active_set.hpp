// What contact points, hats and cells do from one iterate to the next.
#pragma once

#include <cstdint>
#include <vector>

#include "cleft/solve/newton.hpp"

namespace cleft::solve {

/// The active set of an iteration: partners and status of the contact points, status of the hats, cells that flow.
class ActiveSet {
 public:
  /// Takes what the assembler found at an iterate, counts what differs from the one before, and tells whether an
  /// iterate of this increment, not the last one, had the same set: then the iteration goes round in circles.
  bool update(const assembly::Model& model, const assembly::Assembler& assembler, const assembly::History& history,
              const VecX& displacement, Iteration& out);
  /// Whether a hat of mortar contact is among what differed.
  bool multipliers_change() const { return hat_changes_ > 0; }

 private:
  void points(const assembly::Model& model, const assembly::Assembler& assembler, Iteration& out);
  void hats(const assembly::Assembler& assembler, Iteration& out);
  void cells(const assembly::Assembler& assembler, const assembly::History& history, Iteration& out);
  void branches(const assembly::Model& model, const assembly::Assembler& assembler, const VecX& displacement,
                Iteration& out);

  std::vector<Index> partner_, status_, hats_, flows_;
  std::vector<Index> branches_;  // of the return map: 0 elastic, 1 cone, 2 apex
  int hat_changes_ = 0;
  std::vector<std::uint64_t> met_;  // hashes of the sets so far
};

}  // namespace cleft::solve
