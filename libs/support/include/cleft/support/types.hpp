/// \file
/// Small fixed-size vectors and tensors, and the index type, that every library shares.
#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace cleft {

using Vec2 = Eigen::Vector2d;  ///< a point, displacement or force in the plane
using Mat2 = Eigen::Matrix2d;  ///< a second-order tensor in the plane
using Mat4 = Eigen::Matrix4d;  ///< a fourth-order tensor; row and column i + 2 j stand for component (i, j)
using VecX = Eigen::VectorXd;  ///< one number an unknown component

/// Number of a node, triangle, edge, segment or unknown.
using Index = std::int32_t;
inline constexpr Index kNone = -1;

/// z component of the cross product of two vectors in the plane.
inline double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Determinant (Eigen's own would ask every source for the LU header).
inline double det(const Mat2& a) { return a(0, 0) * a(1, 1) - a(0, 1) * a(1, 0); }

/// The vector turned by +90 degrees (counter-clockwise).
inline Vec2 turn_left(const Vec2& a) { return {-a.y(), a.x()}; }

}  // namespace cleft
