/// \file
/// Numbering of the displacement unknowns of a cut mesh.
///
/// The approximation is that of the shifted Heaviside function (Liu and Borja 2010, (78)-(80)),
///
///     u(X) = sum_I N_I(X) d_I + sum_I N_I(X) [H(X) - H(X_I)] a_I,
///
/// written in the equivalent basis that stores, at an enriched node, one displacement per side of the crack: its own
/// one, d_I, and that of the other side continued to it, its ghost g_I = d_I - a_I on the side H = 1 and d_I + a_I on
/// the side H = 0. Each side of a cut triangle is then an ordinary triangle on three unknowns.
#pragma once

#include <vector>

#include "cleft/enrichment/branch.hpp"
#include "cleft/geometry/cut.hpp"

namespace cleft::enrichment {

/// Unknowns are vectors of two components; unknown k has the numbers 2 k and 2 k + 1 in a vector of all components. The
/// first `nodes` unknowns are the nodes' own displacements, in the order of the nodes; the ghosts follow, and then the
/// amplitudes, four for each tip with a ball. Pairs of contact multipliers (contact/multipliers.hpp) may come last.
struct Unknowns {
  Index nodes = 0;
  Index count = 0;             ///< nodes, ghosts, amplitudes and multipliers
  Index first_amplitude = 0;   ///< nodes and ghosts
  std::vector<Index> ghost;    ///< per node: its ghost unknown, or kNone
  std::vector<Index> node_of;  ///< per unknown: the node it belongs to; kNone for an amplitude or multiplier
  /// Per unknown: the side whose displacement it is, as the cut has it; none at a node around which nothing is cut, and
  /// for an amplitude or multiplier.
  std::vector<geometry::MaybeSide> side_of;
  double plateau = kPlateau;  ///< part of a ball's radius within which its functions count in full
  double blunting = 0.0;      ///< of the functions, as a part of the size of the tip's element
  Index multipliers = 0;      ///< how many of the last unknowns are multipliers
  Index enriched() const { return displacements() - nodes; }
  Index displacements() const { return count - multipliers; }  ///< nodes, ghosts and amplitudes
  /// The amplitude of branch function `a` (0 to 3) at a tip, an index into CutMesh::tips; m^(1/2).
  Index amplitude(Index tip, int a) const { return first_amplitude + kBranches * tip + a; }
  Index components() const { return 2 * count; }
};

/// A node is enriched only where the other side covers more than this fraction of the cut triangles around it.
inline constexpr double kLeastSupport = 1e-10;

/// Numbers the unknowns. Nodes at which a crack ends keep a single displacement, so that the jump vanishes there.
Unknowns number_unknowns(const geometry::Mesh& mesh, const geometry::CutMesh& cut);

/// Adds multipliers; returns the first of them.
Index add_multipliers(Unknowns& unknowns, Index count);

/// The unknown that node `corner` (0, 1, 2) of a cut triangle contributes to `side`: its own where the node lies on
/// that side or is not enriched, its ghost otherwise.
Index side_unknown(const Unknowns& unknowns, const geometry::Mesh& mesh, const geometry::CutElement& element,
                   int corner, geometry::Side side);

}  // namespace cleft::enrichment
