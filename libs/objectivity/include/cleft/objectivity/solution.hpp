/// \file
/// What a run says of one state: that which must not depend on the side that is integrated.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "cleft/convergence/curve_distance.hpp"
#include "cleft/problem/specification.hpp"
#include "cleft/support/types.hpp"

namespace cleft::objectivity {

/// The contact points of one face of a crack, along the crack.
struct Face {
  std::string side;              ///< left or right
  std::vector<Vec2> place;       ///< in the configuration in which the faces touch, metres
  std::vector<double> pressure;  ///< Cauchy, Pa, positive in compression; 0 where the crack is open
};

struct Solution {
  std::string side;                                      ///< whose faces are integrated: left, right or both
  std::map<std::string, Vec2> reactions;                 ///< on the body by boundary, N/m
  std::vector<std::pair<std::string, double>> energies;  ///< J/m, by their columns of history.csv
  long increments = 0, iterations = 0;                   ///< up to the load
  std::map<std::string, std::vector<Face>> faces;        ///< by crack; none of a crack without contact points
};

/// The state at a load in the folder of a run of the scene; of several between which cracks have grown, the last. Faces
/// touch in the current configuration; at small strain, in the reference configuration. Throws std::runtime_error if a
/// file cannot be read or has no row at that load.
Solution read_solution(const std::string& folder, double load, const problem::Specification& scene);

/// The solution as it was before the scene was turned.
Solution turned_back(Solution solution, double degrees);

/// Whether a face has two points apart, and so places along it.
bool has_places(const Face& face);

/// Arc length along a crack in that configuration: of a point that of its foot on the curve through the points
/// of one face, counted from the first of them, metres. The curve goes on straight beyond its ends. So the points of
/// both faces get places in common.
class CurrentPlaces {
 public:
  /// Throws std::invalid_argument on a face with fewer than two points apart.
  explicit CurrentPlaces(const Face& face);
  double operator()(const Vec2& point) const;

 private:
  std::vector<Vec2> points_;
  std::vector<double> s_;
};

/// Pressure of a face over the current place.
convergence::Curve pressure_over(const CurrentPlaces& places, const Face& face);

}  // namespace cleft::objectivity
