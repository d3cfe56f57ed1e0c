/// \file
/// One load increment by Newton's method.
#pragma once

#include <functional>
#include <span>

#include "cleft/assembly/assembler.hpp"
#include "cleft/assembly/linear_solver.hpp"
#include "cleft/assembly/state.hpp"

namespace cleft::assembly {

struct NewtonControls {
  double residual_tolerance = 1e-8;    ///< of the largest of reactions, dead loads and contact forces (2-norms)
  double correction_tolerance = 1e-5;  ///< of the displacement since the last converged state (largest component)
  int min_iterations = 0;              ///< corrections made even if the residual is small already
  int max_iterations = 12;
  bool extrapolate = true;  ///< start from the last increment continued
};

/// One iteration: a residual and the correction that it leads to.
struct Iteration {
  double residual = 0.0;    ///< before the correction, relative to the force scale
  double rounding = 0.0;    ///< the residual that rounding alone may leave, likewise relative
  double correction = 0.0;  ///< largest component, relative to the displacement of the increment
  double energy = 0.0;      ///< residual times correction, J/m
  int partner_changes = 0;  ///< contact points with another partner face than an iteration before
  int status_changes = 0;   ///< contact points with another status than an iteration before
  double factor_seconds = 0.0, assembly_seconds = 0.0;
};

/// The outcome of an increment. On success the assembler holds forces and contact pairs at `displacement`.
struct Increment {
  std::optional<Failure> failure;
  VecX displacement;
  std::vector<Iteration> iterations;
  Iteration left;  ///< residual after the last correction, with no correction of its own
};

using IterationObserver = std::function<void(int iteration, const Iteration&)>;

/// Solves for the load with contact partners, active set and stick or slip found anew in every iteration. `state` is
/// only read. Converged when residual and last correction are both below their tolerances; a residual at the level of
/// rounding counts as zero.
Increment solve_increment(const Model& model, const std::vector<Constraint>& constraints, const State& state,
                          double load, const NewtonControls& controls, Assembler& assembler, LinearSolver& solver,
                          const IterationObserver& observer);

/// How fast an iteration converged.
struct ConvergenceOrder {
  double order = 0.0;
  bool at_least = false;  ///< the last correction was at the level of rounding: the true order is not smaller
};

/// Order of convergence, log(c3 / c2) / log(c2 / c1) of the last three corrections whose residuals were above rounding,
/// counted from where no contact point changed its partner or status any more; where there are two only, the next one,
/// which rounding can but enlarge, gives a lower bound. `iterations` are those of one increment and what they left.
/// Nothing where there are not even those, or where the corrections do not fall.
///
/// Corrections, not residuals: Newton's iteration does not depend on how the equations are scaled, and neither do they.
/// The 2-norm of the residuals mixes soft and stiff directions; of three of them the first, which holds the error of
/// the extrapolation, is large in stiff ones that a linear solution removes at once, and the order comes out 0.1 to 0.4
/// low.
std::optional<ConvergenceOrder> convergence_order(std::span<const Iteration> iterations);

/// Size of a residual that rounding alone may leave, N/m (2-norm).
double rounding_floor(const Model& model, const VecX& displacement);

}  // namespace cleft::assembly
