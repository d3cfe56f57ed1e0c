/// \file
/// The mortar method: contact tractions as unknowns of their own, two for every hat function.
///
/// Node i has the multipliers l_N (Pa; l_N < 0 presses) and l_T. With the integrals over all mortar segments opposite
/// the other face (mortar_pairs.hpp)
///
///     G_i = int phi_i g_N ds,     S_i = int phi_i g_T ds,     L_i = int phi_i ds (of the whole hat)
///
/// and, over the intervals e of length l_e that i and its neighbour j end,
///
///     Z_i(q) = sum_e kappa_e l_e / 12 (q_i - q_j),     kappa_e = (tau + [1 - cover_e / cover_0]_+) h / (2 mu)
///
/// the conditions are those of exact contact, but for Z, with the strength s(p) of the interface law at a pressure p:
///
///     open     l_N = 0                            where   L_i l_N + c (G_i - Z_i(l_N)) >= 0   (trial r_N)
///     closed   G_i - Z_i(l_N) = 0                 else
///     stick    S_i - Z_i(l_T - o l_T,past) = 0    where   |L_i l_T + c (S_i - Z_i)| <= L_i s(-r_N / L_i)   (trial
///     r_T),
///                                                 or l_T is above half of the strength and r_T l_T < 0: what slid one
///                                                 way must stick before it slides the other
///     slip     l_T = s(-l_N) sign(r_T)            else
///     touch    l_T = 0                            where the node was open when the last increment had converged
///
/// Z with tau of about 1 is the pressure projection of Dohrmann and Bochev (Int. J. Numer. Meth. Fluids 46 (2004) 183):
/// what the traction in an interval differs from its mean there is treated as if it had the compliance of an element, h
/// its size and mu its shear modulus. Uniform tractions are exact with it. With tau = 0 it is only there where an
/// interval has run past the end of the other face (cover_e, the covered part of it, below cover_0): its node then
/// takes the tractions of its neighbour. The slip counts from the last converged state, and so do the tangential
/// tractions in Z: where nothing moves nothing changes, however often. o is 1 but where less than cover_0 of an
/// interval is left and it was more before: then the past goes with the covered part, so that Z does not depend on the
/// size of the increments, and a node that has lost its support (o = 0) bears what its neighbours do.
///
/// Where both faces carry hat functions, each with half of the weight, Z has the further part
///
///     h / (2 mu) (l_i int phi_i ds -+ l' int phi_i j ds),     j = ds'/ds
///
/// (- for the normal, + for the tangential component) with l' what the other face bears opposite the node, or, if
/// nothing lies there, opposite the place next to it, and the integrals over what lies opposite: the faces' tractions
/// are two unknowns for one, and where they are the same each face's mean gap vanishes. Of the tangential component,
/// too, only the change counts: that beyond the mismatch of the last converged state (the bracket over int phi_i ds).
///
/// c = 2 mu / h only makes units equal. Conditions are in N/m, multipliers in metres (times c),
/// so that they may stand beside forces and displacements.
#pragma once

#include "cleft/contact/mortar_pairs.hpp"

namespace cleft::contact {

/// What the hat functions remember between increments.
struct MultiplierState {
  std::vector<Status> status;          ///< per node
  VecX multiplier;                     ///< l_N and l_T of each node, Pa
  VecX mismatch;                       ///< of each node, the mean of l_T -+ l' over what lies opposite, Pa
  std::vector<double> coverage;        ///< per interval, 0 to 1
  std::vector<AnchorMap> anchor_maps;  ///< anchors
  std::vector<double> slope;           ///< per node, of what lies opposite against the face, the mean over its hat
  std::vector<double> smooth;          ///< per node, Z(l_N), m^2
  double stored = 0.0;                 ///< energy in Z, J/m
  std::vector<InterfaceState> state;   ///< of the interface law, per node; slip is the mean over its hat
};
MultiplierState multipliers_at_rest(const Surfaces& surfaces);

/// A node at the present iterate.
struct NodeState {
  Status status = Status::Open;
  bool supported = false;                 ///< something lies opposite its hat
  bool leans = false;                     ///< little lies opposite one of its intervals
  bool fades = false;                     ///< less lies opposite one of these than at the last converged state
  double normal = 0.0, tangential = 0.0;  ///< l_N, l_T, Pa
  double support = 0.0;                   ///< int phi ds over what lies opposite, metres
  double reach = 0.0;                     ///< int phi j ds, metres; only where both faces carry hat functions
  Vec2 past_mismatch = Vec2::Zero();      ///< MultiplierState::mismatch, of the tangential component, Pa
  Vec2 beyond = Vec2::Zero();             ///< tractions beyond those of the other face and the past mismatch, N/m
  double gap = 0.0, slip = 0.0;           ///< G, S, m^2
  Vec2 smooth = Vec2::Zero();             ///< Z of both components, m^2
  double plastic_slip = 0.0;              ///< S - Z, m^2: the part of the slip that no compliance gives back
  double slides = 0.0;                    ///< sign of the traction of a node that slips

  Vec2 traction() const { return {normal, tangential}; }
};

/// What the other face bears opposite a node, where both carry hat functions.
struct Facing {
  Index mortar_pair = kNone;     ///< whose faces' ends it depends on; kNone: nothing lies opposite
  Index interval_part = kNone;   ///< of the other face
  double second = 0.0;           ///< value of the hat of the second node of the interval part's interval there
  Vec2 traction = Vec2::Zero();  ///< l'_N, -l'_T, Pa: what l_N, l_T are if the faces agree
  Vec2 slope = Vec2::Zero();     ///< its derivative with regard to the place on the other face, Pa
  ValueAndGradient place;        ///< on the other face
};

/// One row of conditions: its values and how they depend on everything.
struct NodeCondition {
  Vec2 value = Vec2::Zero();                                     ///< N/m
  Vec2 by_integral = Vec2::Zero();                               ///< on G and S
  Vec2 by_beyond = Vec2::Zero();                                 ///< on the tractions beyond those of the other face
  Mat2 by_own = Mat2::Zero();                                    ///< on the node's unknowns, N/m per metre
  std::array<Mat2, 2> by_neighbour{Mat2::Zero(), Mat2::Zero()};  ///< on those of the nodes before and after
  std::array<Vec2, 2> by_cover{Vec2::Zero(), Vec2::Zero()};  ///< on int ds over what is covered of the two intervals
};

/// State of the hat functions, and the work of their tractions in one increment that is not stored, J/m.
struct CommittedMultipliers {
  MultiplierState end;
  double friction = 0.0;  ///< dissipated: 0 without friction, and never negative
  double pressure = 0.0;  ///< of the pressure along sloping faces and at mouths, and what Z takes up and does not store
};

/// Which conditions the nodes have: those of their own state, or all that have something opposite those of one that
/// sticks.
enum class Conditions : std::uint8_t { OwnState, Stick };

/// Tractions and conditions of all hat functions.
class Multipliers {
 public:
  /// At the displacements `x` (all components; the multipliers among them), with the partners of the contact points.
  void run(const Surfaces& surfaces, const FacePositions& at, const std::vector<Pair>& pairs, const VecX& x,
           const MultiplierState& past, Conditions conditions = Conditions::OwnState);

  const std::vector<MortarSegment>& mortar_segments() const { return mortar_segments_; }
  const std::vector<MortarPair>& mortar_pairs() const { return mortar_pairs_; }
  const std::vector<MortarIntegrals>& integrals() const { return integrals_; }  ///< per overlap
  const std::vector<SlipByAnchor>& by_anchor() const { return by_anchor_; }     ///< per mortar segment
  /// Per node, without an overlap where the other face has no hat functions; empty if no crack has hat functions on
  /// both faces.
  const std::vector<Facing>& facing() const { return facing_; }
  const std::vector<NodeState>& nodes() const { return nodes_; }
  const std::vector<NodeCondition>& conditions() const { return conditions_; }

  /// The traction at a place on a face that carries hat functions; without one where a node of its interval is open
  /// that side.
  Traction traction(const Surfaces& surfaces, Index face, double eta) const;

  /// The state at the end of the converged increment, and the work of the tractions.
  CommittedMultipliers commit(const Surfaces& surfaces, const FacePositions& at, const MultiplierState& before) const;

 private:
  void find_mortar_pairs(const Surfaces& surfaces, const FacePositions& at, const std::vector<Pair>& pairs,
                         const MultiplierState& past);
  void face_each_other(const Surfaces& surfaces, const FacePositions& at);
  Facing borne_at(const Surfaces& surfaces, Index mortar_pair, const ValueAndGradient& place) const;
  void find_reached(const Surfaces& surfaces);
  struct Smoothing;
  class Rows;
  Smoothing smooth(const Surfaces& surfaces, Index node, const MultiplierState& past);
  void choose_conditions(const Surfaces& surfaces, Index node, const MultiplierState& past, Conditions conditions);
  void choose_by_trial(const Surfaces& surfaces, Index node, const MultiplierState& past, Rows& rows);
  MultiplierState remembered(const Surfaces& surfaces, const FacePositions& at) const;
  double stored_energy(const Surfaces& surfaces) const;
  double friction_work(const Surfaces& surfaces, Index node, const MultiplierState& before) const;
  double smoothing_work(Index node, const MultiplierState& before) const;
  double mouth_work(const Surfaces& surfaces, const FacePositions& at, const MultiplierState& before) const;

  std::vector<MortarSegment> mortar_segments_;
  std::vector<MortarPair> mortar_pairs_;
  std::vector<MortarIntegrals> integrals_;
  std::vector<SlipByAnchor> by_anchor_;
  std::vector<Facing> facing_;
  std::vector<NodeState> nodes_;
  std::vector<NodeCondition> conditions_;
  std::vector<double> covered_;  // per interval, metres
  std::vector<bool> reached_;    // per node: some node of its face has something opposite
};

}  // namespace cleft::contact
