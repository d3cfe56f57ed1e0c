/// \file
/// Displacement and gradient at a point and side as short lists over unknowns: what bulk and contact share.
#pragma once

#include <array>
#include <vector>

#include "cleft/enrichment/inlined_vector.hpp"
#include "cleft/enrichment/unknowns.hpp"

namespace cleft::enrichment {

/// u = sum_k weight_k q_k over three vector unknowns q_k, or seven in the ball of a tip.
struct Stencil {
  InlinedVector<Index> unknown;
  InlinedVector<double> weight;

  /// The displacement, metres, from the components of all unknowns.
  Vec2 displacement(const VecX& components) const {
    Vec2 u = Vec2::Zero();
    for (std::size_t k = 0; k < unknown.size(); ++k) u += weight[k] * components.segment<2>(2 * unknown[k]);
    return u;
  }
};

/// A triangle, or one side of a cut triangle: grad u = sum_k q_k (x) gradient_k, constant, over `area`.
struct Cell {
  std::array<Index, 3> unknown{};
  std::array<Vec2, 3> gradient{};              ///< 1/m
  double area = 0.0;                           ///< m^2, of this side only
  Index element = kNone;                       ///< the triangle
  Index cut = kNone;                           ///< index into CutMesh::elements, or kNone for a whole triangle
  geometry::Side side = geometry::Side::Left;  ///< meaningful for a cut triangle

  geometry::MaybeSide side_if_cut() const { return cut == kNone ? geometry::MaybeSide{} : side; }

  /// Deformation gradient F = I + grad u.
  Mat2 deformation(const VecX& components) const {
    Mat2 F = Mat2::Identity();
    for (int k = 0; k < 3; ++k) F += components.segment<2>(2 * unknown[k]) * gradient[k].transpose();
    return F;
  }
};

/// All cells, in the order of the triangles, without those in the ball of a tip (make_tip_points). A side whose part of
/// the triangle is negligible (kLeastSupport) is dropped.
std::vector<Cell> make_cells(const geometry::Mesh& mesh, const geometry::CutMesh& cut, const Unknowns& unknowns);

/// One side's trace along a face segment. Displacement is linear along it: `start` and `end` give it at its ends. (In a
/// ball it is only taken so; at the ends it is exact.)
struct Face {
  Stencil start, end;                   ///< over the same unknowns
  Vec2 reference_start, reference_end;  ///< metres, along the crack's direction
  double s_start = 0.0, s_end = 0.0;    ///< arc length along the crack, metres
  Index crack = kNone;
  geometry::Side side = geometry::Side::Left;
  Index previous = kNone, next = kNone;       ///< neighbours on the same face
  bool free_start = false, free_end = false;  ///< the face ends here at the boundary of the body (not at a tip)

  /// +1 where the body lies to the right of the crack's direction, -1 where to the left: its outward normal is this
  /// times the tangent (along the crack's direction) turned left.
  double normal_sign() const { return side == geometry::Side::Right ? 1.0 : -1.0; }
};

/// Number of the face of a segment on one side, in the list that make_faces returns.
inline Index face_of(Index segment, geometry::Side side) { return 2 * segment + static_cast<Index>(side); }

/// The face of the same segment on the other side.
inline Index opposite_face(Index face) { return face ^ 1; }

/// Both faces of every segment, numbered by face_of.
std::vector<Face> make_faces(const geometry::Mesh& mesh, const geometry::CutMesh& cut, const Unknowns& unknowns);

}  // namespace cleft::enrichment
