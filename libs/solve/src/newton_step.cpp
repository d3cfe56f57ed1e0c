// The part of Newton's iteration that makes one correction.
#include <algorithm>
#include <cmath>

#include "boundary_values.hpp"
#include "contact_step.hpp"
#include "loose_parts.hpp"
#include "newton_failures.hpp"
#include "newton_iteration.hpp"
#include "tangent_factors.hpp"

namespace cleft::solve {
namespace {

// A correction beyond this many times the body's extent and the prescribed motion comes from a matrix that is singular
// but for rounding. It must not pass: at such displacements the floor of rounding is above every load.
constexpr double kTooFar = 1e3;

double largest_gradient(const assembly::Model& model, const VecX& du) {
  double largest = 0.0;
  for_each_material_point(model, [&](std::size_t, const auto& point, double) {
    largest = std::max(largest, assembly::displacement_gradient(point, du).squaredNorm());
  });
  return std::sqrt(largest);
}

double total(const SolverSeconds& s) { return s.analyse + s.factorise + s.solve; }

}  // namespace

// One correction, or why there is none.
std::optional<assembly::Failure> NewtonIteration::step(Iteration& it) {
  const bool in_place = is_boundary_in_place();
  const VecX by_load = prescribe_boundary(it);
  Bordered system(problem_.solver);
  Correction correction;
  if (auto failure = solve_linear(by_load, system, it, correction)) return failure;
  if (in_place) settle_contact(system, it, correction);
  move(correction);
  const VecX since = out_.displacement - state_.displacement;
  if (parts_held_ && farthest(model_, since) > reach_) return left_behind(model_, since);
  const double moved = since.cwiseAbs().maxCoeff();
  moved_ = correction.displacement.cwiseAbs().maxCoeff();
  correction_ = moved > 0.0 ? moved_ / moved : 0.0;
  record(it, correction.displacement);
  return std::nullopt;
}

// Brings what is prescribed into matrix and right-hand side. Returns what the latter gains with the load, along a path.
VecX NewtonIteration::prescribe_boundary(Iteration& it) {
  const auto& constraints = problem_.constraints;
  LinearSolver& solver = problem_.solver;
  const double modulus = model_.stiffness();
  if (solver.pattern() != assembler_.pattern_version()) solver.new_pattern(assembler_.pattern_version());
  it.kept = solver.has_factors() && (model_.is_linear() || (!along_path() && is_boundary_in_place() &&
                                                            old_factors_do(out_.iterations, it, problem_.controls)));
  if (!it.kept) prescribe(constraints, change_, modulus, assembler_.matrix(), rhs_);
  VecX by_load;
  if (along_path()) {
    Prescription rate = rate_of(model_, constraints, out_.load);
    by_load = std::move(rate.dead);
    prescribe(constraints, rate.displacement, modulus, assembler_.matrix(), by_load);
  }
  if (!it.kept) eliminate(constraints, modulus, assembler_.matrix());
  return by_load;
}

Factors NewtonIteration::factorise(const Iteration& it) {
  if (it.kept) return Factors::Regular;
  const Factors out = problem_.solver.factorise(assembler_.matrix());
  if (!along_path() || out != Factors::Doubtful) return out;
  return factorise_propped(model_, assembler_.matrix(), problem_.solver);
}

std::optional<assembly::Failure> NewtonIteration::solve_linear(const VecX& by_load, Bordered& system, Iteration& it,
                                                               Correction& correction) {
  const double before = total(problem_.solver.seconds());
  const Factors factors = factorise(it);
  if (factors == Factors::Regular) it.pivots = pivots_of_body(problem_.solver, assembler_);
  if (factors != Factors::None) {
    if (along_path()) system.follow(state_.progress, by_load);
    correction.displacement.setZero(rhs_.size());
    correction += system.solve(rhs_);
    if (along_path())
      correction += system.go_on(goal_.arc_increment - state_.progress.dot(out_.displacement - state_.displacement));
  }
  it.factor_seconds = total(problem_.solver.seconds()) - before;
  if (factors == Factors::Regular && correction.displacement.allFinite() &&
      largest(correction.displacement).size <= kTooFar * reach_)
    return std::nullopt;
  auto held = along_path() || it.kept ? std::nullopt
                                      : correction_with_parts_held(model_, problem_.constraints, rhs_, reach_,
                                                                   assembler_.matrix(), problem_.solver);
  if (!held) return useless(model_, factors, correction.displacement);
  correction.displacement = std::move(*held);
  parts_held_ = true;
  return std::nullopt;
}

// Contact that does not settle by itself: the correction that solves the multipliers' complementarity problem exactly
// is added, unless a part of the body that it releases would fly away. Else the correction is halved.
void NewtonIteration::settle_contact(const Bordered& system, Iteration& it, Correction& correction) {
  if (cycling_.struggles() && active_.multipliers_change()) {
    const auto more =
        contact_step(model_, state_.history, out_.displacement, correction.displacement, assembler_, system);
    if (more && more->displacement.allFinite() &&
        farthest(model_, correction.displacement + more->displacement) <= reach_) {
      correction += *more;
      return;
    }
  }
  if (!cycling_.halves()) return;
  correction.displacement *= 0.5;
  correction.load *= 0.5;
  it.cycles = true;
}

void NewtonIteration::move(const Correction& correction) {
  if (along_path()) {
    out_.load += correction.load;
    wanted_ = prescription(model_, problem_.constraints, out_.load);
  }
  out_.displacement += correction.displacement;
  move_boundary(problem_.constraints, wanted_.displacement, out_.displacement, change_);
}

void NewtonIteration::record(Iteration& it, const VecX& du) {
  it.correction = correction_;
  it.gradient = largest_gradient(model_, du);
  it.energy = std::fabs(rhs_.dot(du));
}

}  // namespace cleft::solve
