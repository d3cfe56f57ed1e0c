/// \file
/// The balls around the tips that keep their place.
#pragma once

#include <vector>

#include "trace.hpp"

namespace cleft::geometry {

/// The ball of one tip of crack number `c`. Throws InputError if the crack does not lead away from the tip within it,
/// ends in it or comes back to it.
TipBall make_ball(const Terrain& terrain, const Crack& crack, Index c, const Trace& trace, const TipPassage& tip);

/// Throws InputError where a ball holds a part of another crack or overlaps another ball.
void check_balls(const std::vector<Crack>& cracks, const std::vector<TipBall>& balls);

/// Per triangle of the mesh, the ball that it meets. Throws InputError where it meets two.
std::vector<Index> balls_of_elements(const Mesh& mesh, const std::vector<Crack>& cracks,
                                     const std::vector<TipBall>& balls);

}  // namespace cleft::geometry
