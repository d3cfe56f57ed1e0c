// Nodal forces of tractions and body forces on a cut mesh.
#pragma once

#include <functional>

#include "cleft/assembly/model.hpp"
#include "cleft/problem/specification.hpp"

namespace cleft::problem {

/// A constant traction (Pa) on the edges of a boundary, distributed to the side of the crack that each part of an edge
/// lies on.
VecX traction_force(const assembly::Model& model, const std::string& boundary, const Vec2& traction);

/// A body force density (N/m^3) integrated over all cells with a rule of degree 4 on triangles and sub-triangles. It is
/// asked for at a point and, in a triangle that a crack divides, the side of it.
using Density = std::function<Vec2(const Vec2& point, geometry::MaybeSide side)>;
VecX body_force(const assembly::Model& model, const Density& density);

/// A traction (Pa, per reference area) integrated over both faces of every crack with a rule of degree 3 on their
/// segments, as a dead load. It is asked for at a point, the side whose body it acts on, and the outward normal of that
/// body.
using FaceTraction = std::function<Vec2(const Vec2& point, geometry::Side side, const Vec2& outward)>;
VecX face_force(const assembly::Model& model, const FaceTraction& traction);

/// A place in the bulk to integrate over.
struct BulkPoint {
  Index material_point = kNone;  ///< whose gradient is that of the place
  geometry::MaybeSide side;      ///< in a triangle that a crack divides
  Vec2 reference;                ///< metres
  double weight = 0.0;           ///< m^2
  enrichment::Stencil stencil;   ///< of the displacement
};

/// Visits the quadrature points of every cell, and those of the tips.
void for_each_point(const assembly::Model& model, const std::function<void(const BulkPoint&)>& visit);

/// Loads between 0 and 1 at which an amplitude turns, of boundaries, rotations, tractions and gravity, ascending.
std::vector<double> kinks_of(const Specification& specification);

}  // namespace cleft::problem
