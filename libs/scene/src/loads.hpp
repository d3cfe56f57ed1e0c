// Nodal forces of tractions, gravity and sources on a cut mesh.
#pragma once

#include <functional>

#include "cleft/assembly/model.hpp"

namespace cleft::scene {

/// A constant traction (Pa) on the edges of a boundary, distributed to the side of the crack that each part of an edge
/// lies on.
VecX traction_force(const assembly::Model& model, const std::string& boundary, const Vec2& traction);

/// A body force density (N/m^3) integrated over all cells with a rule of degree 4 on triangles and sub-triangles.
VecX body_force(const assembly::Model& model, const std::function<Vec2(const Vec2&)>& density);

/// Calls visit(cell, point, weight) for the quadrature points of every cell.
void for_each_point(const assembly::Model& model,
                    const std::function<void(const enrichment::Cell&, const Vec2& point, double weight)>& visit);

}  // namespace cleft::scene
