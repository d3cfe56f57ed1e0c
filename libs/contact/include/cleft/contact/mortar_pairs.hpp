/// \file
/// Where two faces lie opposite each other, and what the mortar method integrates there.
#pragma once

#include <array>
#include <span>

#include "cleft/contact/search.hpp"

namespace cleft::contact {

/// Where a part of a face was opposite another one when the last increment had converged: the anchors of its points.
/// Both places are linear along it.
struct AnchorMap {
  Index face = kNone;
  double begin = 0.0, end = 0.0;  ///< places on the face
  Index anchor_face = kNone;
  double anchor_begin = 0.0, anchor_end = 0.0;  ///< places on the other face, opposite begin and end
};

/// What bounds a mortar segment: a material point of its own face, or the normal projection of one of the partner.
struct Bound {
  bool by_partner = false;
  double place = 0.0;  ///< on the partner, 0 at its start, 1 at its end
  bool operator==(const Bound&) const = default;
};

/// A part of an interval part that has one segment of the other face opposite, and one anchor map, or none.
struct MortarSegment {
  Index interval_part = kNone;
  Index partner = kNone;  ///< face
  Index anchor_map = kNone;
  double begin = 0.0, end = 0.0;  ///< places on the interval part's face
  Bound begin_at, end_at;
};

/// The mortar segments, which cover all of the interval parts that has something opposite. They are found from the
/// partners of the contact points along the chains of faces that these belong to. `anchor_maps` ascend by face and
/// place.
std::vector<MortarSegment> find_mortar_segments(const Surfaces& surfaces, const FacePositions& at,
                                                const std::vector<Pair>& pairs,
                                                const std::vector<AnchorMap>& anchor_maps);

/// The anchor maps that mortar segments leave behind: of each point the partner is the next anchor.
std::vector<AnchorMap> anchor_maps_of(const Surfaces& surfaces, const FacePositions& at,
                                      const std::vector<MortarSegment>& mortar_segments);
std::vector<AnchorMap> anchor_maps_at_rest(const Surfaces& surfaces);

/// All that an interval part and a segment of the other face have in common: consecutive mortar segments.
struct MortarPair {
  Index interval_part = kNone, partner = kNone;
  Index first = 0, last = 0;  ///< its mortar segments: first, ..., last - 1
};
std::vector<MortarPair> mortar_pairs_of(const std::vector<MortarSegment>& mortar_segments);

/// What the integrals over an overlap depend on, in this order, two components each: the ends of its own face and of
/// the partner (current, metres), and the multipliers (l_N, l_T) of the nodes of its interval (Pa). Integrals for the
/// nodes depend on the first eight only.
inline constexpr int kMortarInputs = 12, kNodeInputs = 8;
/// Forces on the ends of its own face and of the partner (N/m); for the first node and then for the second the gap and
/// the slip, int phi g_N ds and int phi g_T ds (m^2); and their supports, int phi ds (m).
inline constexpr int kMortarOutputs = 14;
inline constexpr int kGapOutput = 8, kSupportOutput = 12;

/// A value, and how it depends on the ends of the own face and of the partner.
struct ValueAndGradient {
  double value = 0.0;
  Eigen::Matrix<double, 1, kNodeInputs> by = Eigen::Matrix<double, 1, kNodeInputs>::Zero();
};

struct MortarIntegrals {
  Eigen::Matrix<double, kMortarOutputs, 1> value;
  Eigen::Matrix<double, kGapOutput, kMortarInputs> force_by;                ///< derivatives of the forces
  Eigen::Matrix<double, kMortarOutputs - kGapOutput, kNodeInputs> node_by;  ///< and of what follows them
  ValueAndGradient length_ratio;  ///< j = ds'/ds of reference lengths that lie opposite each other; 1 unless both faces
                                  ///< have hat functions
};
/// Derivatives of a mortar segment's slip, of the first and of the second node, with regard to the ends of its anchor's
/// face.
using SlipByAnchor = Eigen::Matrix<double, 2, 4>;

/// Integrals over an overlap, by two Gauss points in each mortar segment, which are exact but for what the curvature of
/// the face makes of them, and their exact derivatives. At a point y with normal n, tangent t and hat functions phi_1,
/// phi_2,
///
///     t_N = sum_k phi_k l_N,k     t_T = sum_k phi_k l_T,k     g_N = (x_B - y) . n     g_T = (x_A - y) . t
///     f   = int (N_+ - N_-)^T (t_N n + t_T t) + t_T g_N dth/dq ds
///
/// with the partner x_B where the point's normal line meets the other face, the anchor x_A where it did when the last
/// increment had converged, and the couple of pair.hpp. Lengths are of the undeformed face; where there is no anchor
/// map the slip is 0. `multipliers` are those of the two nodes, `by_anchor` has an entry for each mortar segment.
void integrate(const Surfaces& surfaces, const FacePositions& at, const std::vector<AnchorMap>& anchor_maps,
               std::span<const MortarSegment> mortar_segments, const std::array<Vec2, 2>& multipliers,
               MortarIntegrals& out, std::span<SlipByAnchor> by_anchor);

/// The place on the segment `g`, 0 at its start and 1 at its end, where the normal line of the place `eta` of the face
/// `f` meets it; at small strain it is `eta` itself.
ValueAndGradient place_opposite(const Surfaces& surfaces, const FacePositions& at, Index f, Index g, double eta);

}  // namespace cleft::contact
