/// \file
/// Where two faces lie opposite each other, and what the mortar method integrates there.
#pragma once

#include <array>

#include "cleft/contact/search.hpp"

namespace cleft::contact {

/// Where a part of a face was opposite another one when the last increment had converged: the anchors of its points.
/// Both places are linear along it.
struct Trail {
  Index face = kNone;
  double begin = 0.0, end = 0.0;  ///< places on the face
  Index anchor_face = kNone;
  double anchor_begin = 0.0, anchor_end = 0.0;  ///< places on the other face, opposite begin and end
};

/// What bounds a piece: a material point of its own face, or the normal projection of one of the partner.
struct Bound {
  bool by_partner = false;
  double place = 0.0;  ///< on the partner, 0 at its start, 1 at its end
  bool operator==(const Bound&) const = default;
};

/// A part of a strip that has one segment of the positive face opposite, one strip of it if it carries hats as well,
/// and one trail, or none.
struct Piece {
  Index strip = kNone;
  Index partner = kNone;        ///< face
  Index partner_strip = kNone;  ///< of the hats of the other face, if both have some
  Index trail = kNone;
  double begin = 0.0, end = 0.0;  ///< places on the strip's face
  Bound begin_at, end_at;
};

/// Pieces that cover all of the strips that has something opposite, found from the partners of the contact points along
/// the chains of faces that these belong to. `trails` ascend by face and place.
std::vector<Piece> find_pieces(const Surfaces& surfaces, const FacePositions& at, const std::vector<Pair>& pairs,
                               const std::vector<Trail>& trails);

/// The trails that pieces leave behind: of each point the partner is the next anchor.
std::vector<Trail> trails_of(const Surfaces& surfaces, const FacePositions& at, const std::vector<Piece>& pieces);
std::vector<Trail> trails_at_rest(const Surfaces& surfaces);

/// What the integrals over a piece depend on, in this order, two components each: the ends of its own face and of the
/// partner (current, metres), the multipliers (l_N, l_T) of the nodes of its own interval (Pa), the ends of the
/// anchor's face, and the multipliers of the nodes of the partner's interval. Forces depend on the first twelve only.
inline constexpr int kPieceInputs = 20, kForceInputs = 12;
inline constexpr int kTractionInput = 8, kAnchorInput = 12, kOtherTractionInput = 16;
/// Forces on the ends of its own face and of the partner (N/m); for the first node and then for the second the gap and
/// the slip, int phi g_N ds and int phi g_T ds (m^2), and what its tractions are beyond those of the other face, int
/// phi (t_N - j t'_N) ds and int phi (t_T + j t'_T) ds (N/m) with j = ds'/ds, the ratio of reference lengths that lie
/// opposite each other; and their supports, int phi ds (m).
inline constexpr int kPieceOutputs = 18;
inline constexpr int kGapOutput = 8, kDifferenceOutput = 12, kSupportOutput = 16;

struct PieceIntegrals {
  Eigen::Matrix<double, kPieceOutputs, 1> value;
  Eigen::Matrix<double, kGapOutput, kForceInputs> force_by;                 ///< derivatives of the forces
  Eigen::Matrix<double, kPieceOutputs - kGapOutput, kPieceInputs> node_by;  ///< and of what follows them
};

/// Integrals over a piece, by two Gauss points, which are exact but for what the curvature of the face makes of them,
/// and their exact derivatives. At a point y with normal n, tangent t and hats phi_1, phi_2,
///
///     t_N = sum_k phi_k l_N,k     t_T = sum_k phi_k l_T,k     g_N = (x_B - y) . n     g_T = (x_A - y) . t
///     f   = int (N_+ - N_-)^T (t_N n + t_T t) + t_T g_N dth/dq ds
///
/// with the partner x_B where the point's normal line meets the other face, the anchor x_A where it did when the last
/// increment had converged, and the couple of pair.hpp. Lengths are of the undeformed face; where there is no trail the
/// slip is 0.
void integrate(const Surfaces& surfaces, const FacePositions& at, const std::vector<Trail>& trails, const Piece& piece,
               const std::array<Vec2, 4>& multipliers, PieceIntegrals& out);

}  // namespace cleft::contact
