/// \file
/// The assembled tangent against differences of the assembled internal force, piece by piece and as a whole.
#pragma once

#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "cleft/assembly/failure.hpp"
#include "cleft/assembly/state.hpp"

namespace cleft::tangent_check {

/// One entry of a tangent, N/m^2 (force per length and displacement).
struct TangentEntry {
  double load = 0.0;
  Index row = kNone;        ///< component, 2 * unknown + direction, of the force
  Index column = kNone;     ///< of the displacement; kNone: one on which the matrix says that the force does not depend
  double exact = 0.0;       ///< as assembled
  double difference = 0.0;  ///< of the force
  double uncertainty = 0.0;  ///< what two sizes of the step disagree by
  double scale = 0.0;        ///< largest entry of the same piece in the row
  Index cell = kNone;        ///< the cell that it belongs to,
  Index point = kNone;       ///< or the contact point; neither in the assembled matrix
  int state = 0;             ///< which of the compared states it is of, from 1; only that one's model has the numbers
  double error() const;      ///< relative to `scale`
};

/// Entries of the same kind.
struct TangentBlock {
  long pieces = 0;  ///< cells or contact points
  long entries = 0;
  long left_out = 0;  ///< entries that depend on a contact point on a kink of the law, or that rounding hides
  TangentEntry worst;
};

/// A cell or contact point that differences cannot judge; neither: a whole state.
struct TangentKink {
  std::string reason;
  double load = 0.0;
  Index cell = kNone, point = kNone;
};

/// |R(u + e v) - R(u) - e K v| as e falls, for the residual R, the assembled tangent K and one direction v that moves
/// every unknown. An exact tangent leaves a remainder of second order in e. A row is judged where it is on one branch
/// and two sizes agree on its part of first order; each row by the sizes that agree best.
struct TaylorTest {
  int states = 0;      ///< that could be judged
  int unclear = 0;     ///< and that could not: no forces, or kinks or rounding at every e in more than half of the rows
  double share = 1.0;  ///< of the rows that were judged, the least of the states that could be
  double order = std::numeric_limits<double>::infinity();  ///< the lowest; of remainders that are more than rounding
  double first_order = 0.0;  ///< the largest part of first order in e, relative to |e K v|
  double load = 0.0;         ///< where that is
  std::string force;         ///< and the component of the force with the most of it, in words
};

/// Names of blocks, without the side of a crack.
using BranchNames = std::set<std::string>;

struct TangentReport {
  /// By name, piece by piece: "bulk", "patch" (of f_bar) and "tip" (points of branch functions), each with the branch
  /// of its law, "elastic", "cone", "apex", "viscous cone" or "viscous apex", of patches also "mixed", and with " left"
  /// or " right" beside a crack; "ghost tie"; "contact open", "contact stick", "contact slip", "contact first touch",
  /// "contact at a mouth". As a whole: "multiplier forces" of mortar contact and the conditions of its nodes; and
  /// "assembled".
  std::map<std::string, TangentBlock> blocks;
  BranchNames possible;  ///< branches that the scene has
  std::vector<TangentKink> kinks;
  TaylorTest taylor;
  int states = 0;

  double worst() const;
  /// Whether some entry of a branch has been judged.
  bool visited(const std::string& branch) const;
  std::vector<std::string> not_visited() const;
  /// Whether some entry was judged of a branch whose name has all these words, which blanks divide.
  bool has_judged(const std::string& words) const;
  /// Why too little was judged to tell whether the tangent holds: no state was compared; blocks of whose entries less
  /// than half was judged, or less than a quarter of the contact points that press; no state's remainder was clear. One
  /// reason each. Empty: enough was.
  std::vector<std::string> gaps() const;
};

/// All branches that there are, and those that a body may come to, whatever happens to it: unless cracks grow, which
/// may cut it in other ways.
BranchNames all_branches();
BranchNames possible_branches(const assembly::Model& model);

/// All words of these names, and whether some name has all of `words`, which blanks divide.
std::vector<std::string> words_of(const BranchNames& names);
bool names_a_branch(const BranchNames& names, const std::string& words);

/// Compares at displacements `u` (metres, all components), reached at `load` from the committed `history`. They must
/// lie off the state in which the history was committed, where each sliding point sits between stick and slip.
///
/// Every cell, patch, point of branch functions, ghost tie and contact point is assembled by itself, and the mortar
/// contact without the body, so that no entry mixes two kinds; then everything together. Differences are five-point
/// ones; their steps follow from the length over which each unknown acts and from the rounding of positions, and are
/// made smaller where a contact point would change its partner, status or mouth, or a material point its branch.
/// What the two central differences within the five points disagree by tells truncation and rounding from a wrong
/// tangent. A piece that no step keeps off a kink, or for which they disagree by more than a quarter of the `tolerance`
/// at every step, is not judged but listed.
///
/// Returns the failure of a state that has no forces; the report is then as it was.
[[nodiscard]] std::optional<assembly::Failure> check_tangent(const assembly::Model& model,
                                                             const assembly::History& history, const VecX& u,
                                                             double load, double tolerance, TangentReport& report);

/// The meaning of a component: direction, node, place, side, and whether it is the node's own displacement.
std::string describe_component(const assembly::Model& model, Index component);

/// The meaning of a piece: element and side, or crack, side and arc length.
std::string describe_piece(const assembly::Model& model, Index cell, Index point);

}  // namespace cleft::tangent_check
