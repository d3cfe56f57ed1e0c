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
/// - Material points take the history of the nearest one of the same triangle, and of the same side where both know
///   theirs: the two sides of a triangle that was whole take its own.
/// - Contact points on old faces keep their memory and their anchors, by crack, side and arc length; those on new faces
///   are anchored at the point opposite and free of stress.
/// - Nothing is known of the increment before.
assembly::State transfer(const assembly::Model& from, const assembly::State& state, const assembly::Model& to);

}  // namespace cleft::growth
