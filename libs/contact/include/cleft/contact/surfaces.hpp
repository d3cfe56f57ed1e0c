/// \file
/// Which faces may touch, where they are integrated, and what a contact point remembers.
#pragma once

#include <span>
#include <vector>

#include "cleft/contact/multiplier_space.hpp"
#include "cleft/contact/springs.hpp"
#include "cleft/enrichment/stencil.hpp"
#include "cleft/support/names.hpp"

namespace cleft::contact {

/// Which side of a crack carries the contact quadrature.
enum class NegativeSide : std::uint8_t { Right, Left, Both };
constexpr std::array<Named<NegativeSide>, 3> names_of(NegativeSide) {
  return {{{NegativeSide::Left, "left"}, {NegativeSide::Right, "right"}, {NegativeSide::Both, "both"}}};
}

/// A quadrature point of a negative face.
struct Point {
  Index face = kNone;        ///< number of its face
  double eta = 0.0;          ///< place on the face, 0 at the start, 1 at the end
  double weight = 0.0;       ///< reference length it stands for, metres (half of it if both sides are integrated)
  double share_begin = 0.0;  ///< the part of the face it stands for
  double share_end = 0.0;
};

/// What a point remembers between increments. Anchors are material points: a face and a place on it.
struct ContactState {
  Index anchor_face = kNone;  ///< kNone: no anchor
  double anchor_place = 0.0;  ///< 0 at the start of the face, 1 at its end, beyond them where the face is continued
  InterfaceState state{};     ///< of the interface law
  // Of the last converged increment, for the work of the next one:
  double normal = 0.0, tangential = 0.0;  ///< t_N and t_T, Pa
  double ramp = 1.0;                      ///< PairState::ramp, 0 without a partner
  double slope = 0.0;                     ///< PairState::slope
};

/// Everything about contact that does not change during an increment.
struct Surfaces {
  std::vector<enrichment::Face> faces;
  std::vector<Point> points;
  std::vector<InterfaceLaw> laws;   ///< per crack
  std::vector<Springs> springs;     ///< per crack, of penalty contact; of a crack with mortar contact it plays no part
  std::vector<NegativeSide> sides;  ///< per crack
  std::vector<Mortar> mortar{};     ///< per crack; empty: all by penalty
  MultiplierSpace multiplier_space{};  ///< on the negative faces of the cracks with mortar contact
  Index first_multiplier = kNone;      ///< unknown of the first hat's multipliers (l_N, l_T), which the others follow
  double element_size = 0.0;           ///< of the cut elements, metres: scale of touch and of the search
  double search_radius = 0.0;          ///< 0: by scale
  bool undeformed = false;             ///< contact in the undeformed configuration (undeformed.hpp), for small strain

  bool is_partner(const enrichment::Face& face) const {
    const NegativeSide side = sides[face.crack];
    return side == NegativeSide::Both || (side == NegativeSide::Left) != (face.side == geometry::Side::Left);
  }
  bool is_mortar(Index crack) const { return !mortar.empty() && mortar[crack].on; }
  /// Whether a face carries the quadrature.
  bool is_negative(const enrichment::Face& face) const {
    const NegativeSide side = sides[face.crack];
    return side == NegativeSide::Both || (side == NegativeSide::Left) == (face.side == geometry::Side::Left);
  }
  Touch touch() const { return {1e-12 * element_size}; }
};

/// Places Gauss points (1 to 4 a segment) on the negative faces.
std::vector<Point> place_points(const Surfaces& surfaces, int per_segment);

/// State at rest: a point whose faces coincide is anchored at the material point opposite.
std::vector<ContactState> contact_at_rest(const Surfaces& surfaces);

}  // namespace cleft::contact
