/// \file
/// Hat functions along the faces of cracks: the space of the contact tractions of the mortar method.
///
/// Tractions are continuous and piecewise linear in the arc length of the undeformed crack, between nodes that are
/// spaced by a multiple of the size of the elements there, wherever the crack crosses their edges. A space with one
/// value for every crossing would be richer than the displacement jumps can answer, and its pressure would oscillate.
#pragma once

#include <array>
#include <vector>

#include "cleft/enrichment/stencil.hpp"

namespace cleft::contact {

/// How the tractions of a crack are found.
struct Mortar {
  bool on = false;          ///< else by penalty
  double hat_width = 1.0;   ///< distance of the nodes, element sizes
  double smoothing = 2.0;   ///< of the tractions within an interval (multipliers.hpp); 0: exact constraints
  double scale = 0.0;       ///< Pa/m; a multiplier's unknown is the multiplier divided by it, metres
  double compliance = 0.0;  ///< h / (2 mu), m/Pa, of an element at the crack
};

struct MultiplierNode {
  Index crack = kNone;
  geometry::Side side = geometry::Side::Left;
  double s = 0.0;                       ///< arc length along the crack, metres
  double length = 0.0;                  ///< integral of its hat, metres (half of it if both sides are integrated)
  Index before = kNone, after = kNone;  ///< the intervals that it ends; kNone at the ends of a face
};

struct MultiplierInterval {
  Index first = kNone, second = kNone;  ///< its nodes
  double length = 0.0;                  ///< metres (half of it if both sides are integrated)
};

/// The part of a face that lies within an interval.
struct IntervalPart {
  Index face = kNone;
  Index interval = kNone;
  double begin = 0.0, end = 0.0;  ///< places on the face, 0 at its start, 1 at its end
};

struct MultiplierSpace {
  std::vector<MultiplierNode> nodes;
  std::vector<MultiplierInterval> intervals;
  std::vector<IntervalPart> interval_parts;  ///< in the order of the faces, and along each
  std::vector<Index> first_part;  ///< per face, and one more: where its interval parts begin; equal if it has none

  bool empty() const { return nodes.empty(); }
  /// Whether a face carries hat functions.
  bool on(Index face) const { return first_part[face] != first_part[face + 1]; }
  /// The nodes of an interval part's interval.
  std::array<Index, 2> ends(Index interval_part) const {
    const auto& interval = intervals[interval_parts[interval_part].interval];
    return {interval.first, interval.second};
  }
  /// The interval part that holds a place on a face; the face must have some.
  Index part_at(Index face, double eta) const;
  /// Value of the hat of the interval's second node at a place on a face; that of the first is 1 less it.
  double second_hat(const enrichment::Face& face, const IntervalPart& interval_part, double eta) const;
};

/// What is integrated on a face: the distance of nodes there (metres), 0 where it carries no hat functions, and the
/// factor of all lengths.
struct MultiplierSpacing {
  double spacing = 0.0;
  double factor = 1.0;
};

/// Places nodes on every chain of faces with a plan: at both of its ends, and between them at the spacing rounded so
/// that it divides the chain; where the spacing varies so do the distances.
MultiplierSpace make_multiplier_space(const std::vector<enrichment::Face>& faces,
                                      const std::vector<MultiplierSpacing>& plan);

}  // namespace cleft::contact
