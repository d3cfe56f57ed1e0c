// What is looked at as a crack is moved over a mesh.
#pragma once

#include <string>
#include <vector>

#include "cleft/problem/specification.hpp"
#include "cleft/solve/stepping.hpp"

namespace cleft::verification {

/// A scene solved in memory, and what small cuts could spoil.
struct Swept {
  std::string failure;            ///< empty where it came to its end with finite numbers
  bool loose = false;             ///< a piece is held by nothing but contact; not solved
  Vec2 reaction = Vec2::Zero();   ///< of the last boundary at the end, N/m
  int cuts = 0;                   ///< increments that failed
  std::vector<int> iterations{};  ///< of each increment
  double condition = 0.0;         ///< of the tangent at rest without springs, scaled symmetrically by its diagonal
  double smallest = 1.0;          ///< least part of a triangle that a side covers, away from tips
  double sliver_stress = 0.0;     ///< norm of the Cauchy stress in that part over the largest beside it on its side
};
Swept sweep(const problem::Specification& scene);

/// A crack of one to four random segments in the block, on a random mesh (every other one Delaunay, the rest structured
/// with nodes moved, in a file of that folder), with random loads, friction and negative side. The same on every
/// machine.
std::vector<std::string> random_crack(unsigned seed, const std::string& folder);

}  // namespace cleft::verification
