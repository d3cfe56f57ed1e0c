// Where the material points of a model are.
#pragma once

#include "cleft/assembly/model.hpp"
#include "cleft/geometry/disc.hpp"

namespace cleft::growth {

/// Centre of the part of the body that a material point stands for, metres: of a triangle, of one side of a cut one, or
/// the point itself in the ball of a tip.
Vec2 place_of(const assembly::Model& model, Index point);

/// Area of what a material point stands for within a disc, m^2: exactly, for a triangle or one side of a cut one; of a
/// point in the ball of a tip as large a part as of its triangle.
double area_within(const geometry::Disc& disc, const assembly::Model& model, Index point);

}  // namespace cleft::growth
