/// \file
/// Forces through the prescribed boundaries, also where several hold the same node.
#pragma once

#include "cleft/assembly/state.hpp"

namespace cleft::assembly {

/// Divides the forces of constraints among the boundaries that prescribe them. Most belong to one. A component of a
/// node that several prescribe (they agree in its value) has the force f, of which boundary b bears
///
///     f_b = a_b + (f - sum a) L_b / sum L,     a_b = sum P N L_e / 2,     L_b = sum L_e
///
/// over the edges e of b that end at the node, with their outward normal N and length L_e (that of an edge of m
/// boundaries counts for each by 1/m) and the nominal stress P of the triangle behind: what the traction there exerts
/// on the node, and a part of what remains by length. So a uniform stress gives every boundary exactly its traction by
/// its length, the parts add up to f, and the order of the boundaries does not matter. Behind an edge that a crack cuts
/// or a ball of branch functions reaches P is not taken; without any edges the parts are equal. P of a cell in a patch
/// is that of its law at Fbar, without what (1.8) hands to and fro between both cells: that is part of what remains.
class Reactions {
 public:
  Reactions(const Model& model, const std::vector<Constraint>& constraints);

  /// Force on the body through each boundary, N/m, in the order of Model::prescribed. `force` is that of each
  /// constraint, N/m, at the state. Model and constraints are those of the constructor.
  std::vector<Vec2> operator()(const Model& model, const std::vector<Constraint>& constraints, const VecX& force,
                               const State& state) const;

 private:
  // An edge of a boundary at a node that it shares.
  struct Edge {
    Index cell;    // behind it, or kNone
    Vec2 normal;   // outward, by half of the edge's length, metres
    double share;  // 1 / number of boundaries
  };
  struct Holder {
    Index boundary;
    std::vector<Edge> edges;
  };
  struct Shared {
    Index constraint;
    std::vector<Holder> holders;
  };

  static std::vector<double> parts(const Model& model, const Shared& shared, int direction, double force,
                                   const State& state);

  std::vector<Shared> shared_;  // ascending in constraint
};

}  // namespace cleft::assembly
