/// \file
/// The cure of small cuts: where one side of the crack covers next to nothing of the triangles around a ghost, its
/// displacement is tied to that of the body behind it.
#pragma once

#include <array>
#include <vector>

#include "cleft/enrichment/stencil.hpp"

namespace cleft::enrichment {

/// The jump of the normal derivative across an edge between two triangles of one side, sum_k slope_k q_k. Its square
/// times `weight` and a modulus is the energy of the penalty. It does not change when the body turns, vanishes where
/// the displacement is linear, and shrinks like h^2 where it is smooth (Burman, C. R. Math. 348 (2010) 1217).
struct GhostTie {
  std::array<Index, 4> unknown{};
  std::array<double, 4> slope{};  ///< 1/m
  double weight = 0.0;            ///< m^2: the strength, times the edge's length squared
  Index cell = kNone;             ///< one of the two triangles on this side, whose modulus counts

  Vec2 jump(const VecX& components) const {
    Vec2 out = Vec2::Zero();
    for (std::size_t k = 0; k < unknown.size(); ++k) out += slope[k] * components.segment<2>(2 * unknown[k]);
    return out;
  }
};

/// A ghost whose side covers less than this part of the cut triangles around its node is tied.
inline constexpr double kSmallSupport = 0.1;

/// Strength of the ties where the support vanishes; it falls linearly to 0 at kSmallSupport.
inline constexpr double kTieStrength = 0.03;

/// All ties; none where no cut is small.
std::vector<GhostTie> make_ghost_ties(const geometry::Mesh& mesh, const geometry::CutMesh& cut,
                                      const Unknowns& unknowns, const std::vector<Cell>& cells);

/// Per node, the part of the cut triangles around it that lies on the other side of the crack; 0 where nothing is cut.
std::vector<double> other_side_support(const geometry::Mesh& mesh, const geometry::CutMesh& cut);

}  // namespace cleft::enrichment
