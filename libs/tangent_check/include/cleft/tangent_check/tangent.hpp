/// \file
/// The assembled tangent against differences of the assembled internal force, piece by piece and as a whole.
#pragma once

#include <map>
#include <optional>
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
  double error() const;      ///< relative to `scale`
};

/// Entries of the same kind.
struct TangentBlock {
  long pieces = 0;  ///< cells or contact points
  long entries = 0;
  long left_out = 0;  ///< entries that depend on a contact point on a kink of the law, or that rounding hides
  TangentEntry worst;
};

/// A cell or contact point that differences cannot judge.
struct TangentKink {
  std::string reason;
  double load = 0.0;
  Index cell = kNone, point = kNone;
};

struct TangentReport {
  /// By name: "bulk", "bulk left", "bulk right" (whole triangles, and either side of cut ones) cell by cell, and
  /// "patch", "patch left", "patch right" of f_bar; "contact open", "contact stick", "contact slip", "contact first
  /// touch", "contact at a mouth" point by point; "assembled".
  std::map<std::string, TangentBlock> blocks;
  std::vector<TangentKink> kinks;
  int states = 0;

  double worst() const;
  /// Whether at least half of the entries of every block were judged, and contact points that press if there are any.
  bool enough() const;
};

/// Compares at displacements `u` (metres, all components), reached at `load` from the committed `history`. They must
/// lie off the state in which the history was committed, where each sliding point sits between stick and slip.
///
/// Every cell and every contact point is assembled by itself, so that no entry mixes two kinds, and then everything
/// together. Differences are five-point ones; their steps follow from the length over which each unknown acts and from
/// the rounding of positions, and are made smaller where a contact point would change its partner, status or mouth.
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
