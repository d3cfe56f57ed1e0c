/// \file
/// Partners of contact points in the current configuration, with no bound on the slip.
#pragma once

#include "cleft/contact/pair.hpp"
#include "cleft/contact/surfaces.hpp"
#include "cleft/geometry/segment_grid.hpp"

namespace cleft::contact {

/// A contact point with its partner at the present iterate.
struct Pair {
  Index partner_face = kNone;  ///< kNone: nothing opposite
  Index mouth_face = kNone;    ///< the face whose free end the point may run past, or kNone
  bool mouth_at_end = false;   ///< the free end is that face's end (else its start)
  /// Whether the point has an anchor, on the face that the partner is on: one on another face holds nothing, and the
  /// point touches anew.
  bool anchored = false;
  PairState state;
};

/// Whether the point's anchor is on the same face of the same crack as `partner_face`.
inline bool holds_on(const Surfaces& surfaces, const ContactState& past, Index partner_face) {
  if (past.anchor_face == kNone) return false;
  const auto &anchor = surfaces.faces[past.anchor_face], &partner = surfaces.faces[partner_face];
  return anchor.crack == partner.crack && anchor.side == partner.side;
}

/// Whether the point has a partner and is not open.
inline bool presses(const Pair& pair) {
  return pair.partner_face != kNone && pair.state.traction.status != Status::Open;
}

/// Current positions of all faces' ends. In contact in the undeformed configuration only their displacements: gaps are
/// jumps of these, and of a small one the places would take the last digits.
struct FacePositions {
  std::vector<Vec2> start, end;  ///< per face, metres
};
/// At a displacement (components of all unknowns, metres).
void place_faces(const Surfaces& surfaces, const VecX& displacement, FacePositions& out);

/// Finds partners: those opposite where contact is in the undeformed configuration, else in the current one. Keeps its
/// scratch state between calls.
class Search {
 public:
  /// `displacement`: components of all unknowns. The partner is the nearest crossing of the point's normal line with a
  /// face that faces it (n_+ . n < 0) within the search radius, which is the larger of 5 element sizes and ten times
  /// `deepest`, the largest penetration so far (metres), unless the surfaces set one. Past the free end of a face its
  /// last segment counts as continued until the point's whole share has passed.
  void run(const Surfaces& surfaces, const VecX& displacement, const std::vector<ContactState>& past, double deepest,
           std::vector<Pair>& pairs);

  const FacePositions& positions() const { return positions_; }

 private:
  void find_nearest(const Surfaces& surfaces, const std::vector<ContactState>& past, double deepest,
                    std::vector<Pair>& pairs);
  void collect_partners(const Surfaces& surfaces);

  FacePositions positions_;
  geometry::SegmentGrid grid_;
  std::vector<Index> partners_, mouths_;
  std::vector<Vec2> partner_start_, partner_end_;
};

/// What springs and law answer to the gaps of a pair, at either strain, from what the point remembers.
ContactResponse response(const Surfaces& surfaces, Index point, const Pair& pair, const ContactState& past);

/// The six points of a pair, from current positions.
PairPoints pair_points(const Surfaces& surfaces, const FacePositions& at, Index point, const Pair& pair,
                       const ContactState& past);
PairConstants pair_constants(const Surfaces& surfaces, const FacePositions& at, Index point, const Pair& pair,
                             const ContactState& past);

}  // namespace cleft::contact
