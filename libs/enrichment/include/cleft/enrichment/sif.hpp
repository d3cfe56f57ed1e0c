/// \file
/// Stress intensity factors: the singular fields of modes I and II, and the interaction integral that finds their parts
/// in a computed field. Small strain, plane strain, linear elasticity.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "cleft/enrichment/tip_points.hpp"

namespace cleft::enrichment {

/// Isotropic, in plane strain.
struct PlaneStrain {
  double shear_modulus = 1.0;  ///< Pa
  double poisson_ratio = 0.3;  ///< below 1/2
  double kappa() const { return 3.0 - 4.0 * poisson_ratio; }
  Mat2 stress(const Mat2& gradient) const;  ///< Pa, in the plane
};

/// Opens the crack, or lets its faces slide. K_II > 0 where the side at angle +pi slides ahead.
enum class Mode { I, II };

/// Amplitudes c_a of the branch functions that make the displacement of a mode of intensity 1 Pa m^(1/2) (Williams
/// 1957), along the axes straight ahead of the crack and left of that; m^(1/2).
std::array<Vec2, kBranches> unit_amplitudes(Mode mode, const PlaneStrain& body);

/// The field of a mode of intensity 1 Pa m^(1/2) at (r, angle), components along the axes straight ahead and left of
/// that. On a straight crack (angle = +-pi) it has no traction.
struct ModeField {
  Vec2 displacement;  ///< metres
  Mat2 gradient;      ///< of it, entry (i, j) of component i along axis j
  Mat2 stress;        ///< Pa
};
ModeField unit_field(Mode mode, double r, double angle, const PlaneStrain& body);

struct Intensities {
  double K_I = 0.0, K_II = 0.0;  ///< Pa m^(1/2)
};

/// What the amplitudes of a tip say: the part of the second function, the one that jumps. Of first order in h, where
/// the interaction integral is of second; and where the faces carry traction p, off by about 0.04 p h^(1/2),
/// because they do so along chords.
Intensities intensities_of_amplitudes(const geometry::TipBall& ball, const std::array<Vec2, kBranches>& amplitudes,
                                      const PlaneStrain& body);

/// A computed state at a point, in the axes of the mesh. Strains and turns are small; of a body that has been turned
/// rigidly it is that before the turn.
struct PointState {
  Mat2 gradient;  ///< of the displacement
  Mat2 stress;    ///< Pa: s_ij along axis i, per reference area normal to axis j
};

/// A piece of a face near the tip, over which the traction is taken as uniform.
struct FacePiece {
  Vec2 start, end;      ///< metres, along the face in either direction
  geometry::Side side;  ///< whose face it is
  Vec2 traction;        ///< Pa, on the body of this side
};

/// What loads the body near a tip.
struct TipLoads {
  std::vector<FacePiece> faces;
  Vec2 body_force = Vec2::Zero();  ///< N/m^3, uniform
};

/// Interaction integral in its domain form (Yau, Wang and Corten 1980; Shih and Asaro 1988), for each mode
///
///     I = int [ s_ij v_i,1 + z_ij u_i,1 - s_mn v_m,n d_1j ] q_,j dA - int b_i v_i,1 q dA - int_faces t_i v_i,1 q ds,
///     K = E' I / 2,
///
/// over the points of one tip, with the computed field u and s, the mode's field v and z, and a weight q that falls
/// smoothly from 1 to 0 at the ball's reach. The third integral, over both faces, is that of contact: without it K
/// depends on the reach where closed faces carry traction; it is exact for v_i,1, which is singular.
///
/// `points` may hold those of other tips. t and b are those of `loads`.
Intensities interaction_integral(const geometry::TipBall& ball, Index tip, const std::vector<TipPoint>& points,
                                 const std::function<PointState(const TipPoint&)>& state, const TipLoads& loads,
                                 const PlaneStrain& body);

}  // namespace cleft::enrichment
