/// \file
/// A state handed on to the same body with longer cracks.
#pragma once

#include "cleft/assembly/state.hpp"

namespace cleft::growth {

/// The state of `from` on `to`: the same mesh and materials, cracks that are the same or longer. In general not in
/// balance.
///
/// - A node keeps its displacement and, where it had one, its ghost; a new ghost starts with the node's own
///   displacement, so that new faces are closed. Branch functions of a tip that has moved start at zero.
/// - Where a triangle is cut anew each of its parts takes the mean plastic history over the areas that it has in common
///   with the old ones, theory (10.10): each triangle keeps its integral of what has accumulated and, at small strain,
///   of the plastic strain, to rounding (parts that the cutter neglects, kLeastSupport, apart). At finite strain the
///   mean is that of ln C^p^-1 (FinitePlastic::mean). Points in the ball of a tip are spread over the triangle of the
///   quadrature that they stand for. Triangles whose parts stay, and both sides of one that was whole, keep their
///   history to the last bit. The mean may lie beyond yield, which the balance after it mends. Bodies
///   with patches (assembly/f_bar.hpp) keep elastic volumes and not plastic ones, theory (10.11), since cells may
///   have other partners than before: so pressures stay, nothing makes energy, and histories are kept to rounding.
/// - Contact points on old faces keep their states and their anchors, by crack, side and arc length; those on new faces
///   are anchored at the point opposite and free of stress.
/// - Nothing is known of the increment before.
assembly::State transfer(const assembly::Model& from, const assembly::State& state, const assembly::Model& to);

}  // namespace cleft::growth
