// The load at which the largest demand reaches 1, between two loads.
#pragma once

namespace cleft::growth {

/// Demands below and above 1 at two loads.
struct Bracket {
  double low = 0.0, demand_low = 0.0;
  double high = 0.0, demand_high = 0.0;
};

/// Where to look next. Along the straight line through both ends first a little before the crossing, then, once that is
/// within the tolerance of `low`, a little beyond it: so two looks suffice where the demand goes nearly straight.
/// `halve` where that has not helped.
double next_look(const Bracket& bracket, double tolerance, bool halve);

}  // namespace cleft::growth
