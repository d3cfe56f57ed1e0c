// What a solved scene shows that its user should know.
#pragma once

#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "cleft/growth/evolution.hpp"
#include "cleft/problem/specification.hpp"
#include "cleft/results/counts.hpp"

namespace cleft::simulation {

/// How much the values vary beyond one rise and one fall, over their maximum; 0 where none is positive. What lies in
/// the outer tenths of `place`, which ascends, does not count.
double oscillation(std::span<const double> place, std::span<const double> value);

/// A contact point: arc length (m), pressure (Pa), and whether the faces touch there.
using Pressed = std::tuple<double, double, bool>;

/// The largest oscillation of a zone in which the faces touch, over the elements of `size` metres that it counts in.
/// Where they part for less than two elements the zone goes on.
double worst_zone(std::vector<Pressed> along, double size);

/// One line each, with the figure that speaks for it. On the last converged state, unless that is the one at rest:
/// faces that overlap, a contact pressure that oscillates, energy that is not accounted for, jumps to another
/// equilibrium, flow in which triangles lock. On forces that rounding blurs: of some increments, or all of a body that
/// bears next to nothing. On cracks that grow (remarks_on_growth), and on the reach of tips that have advanced.
std::vector<std::string> remarks_after(const problem::Specification& specification, const growth::Evolution& evolution,
                                       const results::Counts& counts);

}  // namespace cleft::simulation
