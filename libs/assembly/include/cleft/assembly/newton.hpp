/// \file
/// One load increment by Newton's method.
#pragma once

#include <functional>

#include "cleft/assembly/assembler.hpp"
#include "cleft/assembly/linear_solver.hpp"
#include "cleft/assembly/state.hpp"

namespace cleft::assembly {

struct NewtonControls {
  double residual_tolerance = 1e-8;    ///< of the largest of reactions, dead loads and contact forces (2-norms)
  double correction_tolerance = 1e-5;  ///< of the displacement since the last converged state (largest component)
  int max_iterations = 12;
  bool extrapolate = true;  ///< start from the last increment continued
};

/// One iteration: a factorisation and a solution.
struct Iteration {
  double residual = 0.0;    ///< before the correction, relative to the force scale
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
  double final_residual = 0.0;  ///< relative, after the last correction
  double rounding = 0.0;        ///< relative residual that rounding alone may leave
};

using IterationObserver = std::function<void(int iteration, const Iteration&)>;

/// Solves for the load with contact partners, active set and stick or slip found anew in every iteration. `state` is
/// only read. Converged when residual and last correction are both below their tolerances; a residual at the level of
/// rounding counts as zero.
Increment solve_increment(const Model& model, const std::vector<Constraint>& constraints, const State& state,
                          double load, const NewtonControls& controls, Assembler& assembler, LinearSolver& solver,
                          const IterationObserver& observer);

/// Size of a residual that rounding alone may leave, N/m (2-norm).
double rounding_floor(const Model& model, const VecX& displacement);

}  // namespace cleft::assembly
