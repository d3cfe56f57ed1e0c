// What a solved scene shows that its user should know.
#pragma once

#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "cleft/growth/evolution.hpp"
#include "cleft/problem/specification.hpp"
#include "cleft/simulation/run.hpp"
#include "cleft/solve/stepping.hpp"

namespace cleft::simulation {

/// How much the values vary beyond one rise and one fall, over their maximum; 0 where none is positive. What lies in
/// the outer tenths of `place`, which ascends, does not count.
double oscillation(std::span<const double> place, std::span<const double> value);

/// A contact point: arc length (m), pressure (Pa), and whether the faces touch there.
using Pressed = std::tuple<double, double, bool>;

/// The largest oscillation of a zone in which the faces touch, over the elements of `size` metres that it counts in.
/// Where they part for less than two elements the zone goes on.
double worst_zone(std::vector<Pressed> along, double size);

/// On the last converged state, one line each, with the figure that speaks for it: faces that overlap, a contact
/// pressure that oscillates, energy that is not accounted for, jumps to another equilibrium, flow in which triangles
/// lock. Nothing before the first increment.
std::vector<std::string> remarks_at_end(const problem::Specification& scene, const solve::LoadStepper& stepper,
                                        const results::Jumps& jumps);

/// On forces that rounding blurs: of some increments, or all of a body that bears next to nothing.
std::vector<std::string> remarks_on_rounding(const results::Rounded& rounded, const solve::LoadStepper& stepper);

/// On what cracks that may grow have done: none did, and how near one came; a tip that is hindered; a path that turns
/// to and fro.
std::vector<std::string> remarks_on_growth(const problem::Specification& scene, const growth::Record& record);

}  // namespace cleft::simulation
