/// \file
/// The triangles that a tip's ball meets, as quadrature points: their displacement is not linear.
///
/// There the displacement is that of the three unknowns of the triangle, or of its side, and of the four vector
/// amplitudes c_a of the tip,
///
///     u(X) = sum_k N_k(X) q_k + sum_a c_a chi(r) [ F_a(X) - sum_k N_k(X) F_a(X_k) ],
///
/// with the branch functions F_a and the cutoff chi. F_a(X_k) is taken on the side of unknown k: at the node for the
/// node's own displacement, and for a ghost continued to the node over the crack. So the unknowns keep their meaning,
/// the displacement of that side at that node, and the amplitudes tell how it goes between the nodes. Amplitudes are
/// vectors and functions numbers, so that a rigid rotation of the body turns them with everything else.
///
/// One amplitude a function and tip, as by Chahine, Laborde and Renard (2008); but they cut off F_a itself, whose
/// curvature in the layer where chi falls is then left to the linear triangles. Here what these cannot represent is cut
/// off, the difference of F_a from its interpolant (as by Babuska and Banerjee 2012), which costs O(h^2) in that layer.
#pragma once

#include <array>
#include <vector>

#include "cleft/enrichment/stencil.hpp"

namespace cleft::enrichment {

/// A quadrature point of a triangle in a ball: grad u = sum_k q_k (x) gradient_k.
struct TipPoint {
  Index element = kNone;                       ///< the triangle
  geometry::MaybeSide side;                    ///< where the triangle is divided; in the tip's own, by the crack led on
  Index tip = kNone;                           ///< index into CutMesh::tips
  std::array<Index, 3 + kBranches> unknown{};  ///< of the triangle or its side, then the amplitudes
  std::array<Vec2, 3 + kBranches> gradient{};  ///< 1/m, then m^(-1/2)
  double weight = 0.0;                         ///< m^2
  Vec2 reference = Vec2::Zero();               ///< metres

  /// Deformation gradient F = I + grad u.
  Mat2 deformation(const VecX& components) const {
    Mat2 F = Mat2::Identity();
    for (std::size_t k = 0; k < unknown.size(); ++k)
      F += components.segment<2>(2 * unknown[k]) * gradient[k].transpose();
    return F;
  }
};

/// The points of all triangles that meet a ball, ball after ball, in each in the order of the triangles; none of these
/// triangles has a Cell. Triangles are divided until they are small against their distance from the tip; those with a
/// corner at the tip are integrated in polar coordinates. With `refinement` every triangle is divided into 4^refinement
/// more, to see what the quadrature costs in accuracy.
std::vector<TipPoint> make_tip_points(const geometry::Mesh& mesh, const geometry::CutMesh& cut,
                                      const Unknowns& unknowns, int refinement = 0);

/// A part of a triangle on one side of the crack (none where it is whole), as counter-clockwise triangles.
struct Piece {
  geometry::MaybeSide side;
  std::vector<std::array<Vec2, 3>> triangles;
};

/// How a triangle in a ball is divided.
std::vector<Piece> pieces_of(const geometry::Mesh& mesh, const geometry::CutMesh& cut, Index element);

/// What the points of a triangle in a ball stand for: each of these for as many of them as it says, one after the other
/// in the order of make_tip_points without refinement; the weights of these add up to its area.
struct TipPart {
  std::array<Vec2, 3> corners;  ///< counter-clockwise, metres
  int points = 0;
};
std::vector<TipPart> tip_parts(const geometry::Mesh& mesh, const geometry::CutMesh& cut, Index element);

/// The blunting of a tip's functions, metres.
double blunting_at(const geometry::Mesh& mesh, const Unknowns& unknowns, const geometry::TipBall& ball);

/// The displacement at `point` of triangle `element`, on `side` of it where it is divided, or at a face of a tip's own
/// triangle: three unknowns, or seven in a ball.
Stencil stencil_at(const geometry::Mesh& mesh, const geometry::CutMesh& cut, const Unknowns& unknowns, Index element,
                   geometry::MaybeSide side, const Vec2& point);

}  // namespace cleft::enrichment
