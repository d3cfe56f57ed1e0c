// Small specifications that tests of several libraries are made of. SI units.
#pragma once

#include <numbers>

#include "cleft/problem/build.hpp"

namespace cleft::problem::small {

constexpr double kYoung = 1e10;  // Pa

inline MaterialSpec elastic(double young = kYoung, double poisson = 0.25) {
  MaterialSpec out;
  out.model = "hencky";
  out.young = young;
  out.poisson = poisson;
  return out;
}

/// A crack with Coulomb friction in contact by multipliers.
inline CrackSpec crack_with_multipliers(const geometry::Crack& crack, double friction,
                                        contact::NegativeSide side = contact::NegativeSide::Right) {
  CrackSpec out;
  out.name = crack.name;
  out.points = crack.points;
  out.negative_side = side;
  out.law = contact::Coulomb{friction};
  return out;
}

/// The same in contact by springs of `penalty`, Pa/m.
inline CrackSpec crack_with_springs(const geometry::Crack& crack, double friction, double penalty,
                                    contact::NegativeSide side = contact::NegativeSide::Right) {
  CrackSpec out = crack_with_multipliers(crack, friction, side);
  out.mortar.on = false;
  out.normal_penalty = out.tangential_penalty = penalty;
  return out;
}

/// The part `on` of the boundary moves by `at_full_load`, metres.
inline BoundarySpec held(const std::string& on, const Vec2& at_full_load) {
  BoundarySpec out;
  out.name = out.on = on;
  out.ux = at_full_load.x();
  out.uy = at_full_load.y();
  return out;
}

/// Turns what `boundary` holds by `angle`, radians at full load, about the origin.
inline BoundarySpec turned(BoundarySpec boundary, double angle) {
  boundary.rotation = {Vec2::Zero(), angle * 180.0 / std::numbers::pi, {}};
  return boundary;
}

/// An elastic block of 0.04 m by 0.08 m whose bottom is held.
inline Specification block(std::array<int, 2> cells, const Vec2& top, const CrackSpec& crack,
                           geometry::Diagonal diagonal = geometry::Diagonal::Right) {
  Specification out;
  out.mesh.kind = StructuredMesh{{0, 0, 0.04, 0.08}, cells, diagonal, {}};
  out.materials = {elastic()};
  out.cracks = {crack};
  out.boundaries = {held("bottom", {0, 0}), held("top", top)};
  return out;
}

}  // namespace cleft::problem::small
