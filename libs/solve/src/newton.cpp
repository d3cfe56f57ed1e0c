#include "cleft/solve/newton.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "active_set.hpp"
#include "bordered.hpp"
#include "chatter.hpp"
#include "contact_step.hpp"
#include "loose_parts.hpp"
#include "prescription.hpp"
#include "rounding.hpp"

namespace cleft::solve {
namespace {

// Extrapolation pays only while the boundary goes on as before.
constexpr double kSameWay = 0.5;

// Whether u has become the last increment continued.
bool predict(const assembly::State& state, const std::vector<assembly::Constraint>& constraints, const VecX& target,
             double load, VecX& u) {
  const double before = state.load - state.previous_load;
  if (!(before > 0.0)) return false;
  const VecX guess =
      state.displacement + ((load - state.load) / before) * (state.displacement - state.previous_displacement);
  double missed = 0.0, moved = 0.0;
  for (std::size_t k = 0; k < constraints.size(); ++k) {
    const Index c = constraints[k].component;
    missed = std::max(missed, std::fabs(target[k] - guess[c]));
    moved = std::max(moved, std::fabs(target[k] - state.displacement[c]));
  }
  if (missed > kSameWay * moved) return false;
  u = guess;
  return true;
}

// A correction beyond this many times the body's extent and the prescribed motion comes from a matrix that is singular
// but for rounding. It must not pass: at such displacements the floor of rounding is above every load.
constexpr double kFlewAway = 1e3;

// A residual at the level of rounding that users would notice ends the iteration once it no longer falls to this part
// of the one before: the level is but an estimate.
constexpr double kStillFalls = 0.5;

// A residual that no longer falls is rounding, too, up to this many times the level: the solution of the equations has
// errors of its own, as on needles.
constexpr double kNearRounding = 100.0;

double extent_of(const geometry::Mesh& mesh) {
  const auto [low, high] = geometry::box_around(mesh);
  return (high - low).norm();
}

struct Extreme {
  Index component = kNone;
  double size = 0.0;  // without sign
};

Extreme largest(const VecX& values) {
  Eigen::Index at = 0;
  const double size = values.cwiseAbs().maxCoeff(&at);
  return {static_cast<Index>(at), size};
}

// What an iteration that does not converge looks like at its end.
assembly::Failure unbalanced(const assembly::Model& model, const Iteration& last, int iterations, const VecX& residual,
                             int halved) {
  return {assembly::FailureKind::NoConvergence,
          assembly::Unbalanced{last.residual, iterations, position_of(model, largest(residual).component),
                               last.status_changes + last.partner_changes, halved}};
}

double largest_gradient(const assembly::Model& model, const VecX& du) {
  double largest = 0.0;
  for_each_material_point(model, [&](std::size_t, const auto& point, double) {
    largest = std::max(largest, assembly::displacement_gradient(point, du).squaredNorm());
  });
  return std::sqrt(largest);
}

// Takes what the prescribed components do to the others to the right-hand side, and their own change into it.
void prescribe(const std::vector<assembly::Constraint>& constraints, const VecX& change, double diagonal,
               const assembly::BlockMatrix& matrix, VecX& rhs) {
  if (change.size() == 0) return;
  if (change.cwiseAbs().maxCoeff() > 0.0) {
    VecX full = VecX::Zero(rhs.size());
    for (std::size_t k = 0; k < constraints.size(); ++k) full[constraints[k].component] = change[k];
    rhs -= matrix.multiply(full);
  }
  for (std::size_t k = 0; k < constraints.size(); ++k) rhs[constraints[k].component] = diagonal * change[k];
}

// Replaces the rows and columns of the prescribed components by a diagonal, so that the matrix keeps its symmetry.
void eliminate(const std::vector<assembly::Constraint>& constraints, double diagonal, assembly::BlockMatrix& matrix) {
  auto values = matrix.values();
  for (const auto& constraint : constraints) {
    const Index c = constraint.component, block = c / 2, direction = c % 2;
    for (const Index row : matrix.block_rows(block)) {
      const auto down = matrix.find(row, block), across = matrix.find(block, row);
      for (int i = 0; i < 2; ++i) {
        values[down.start + direction * down.stride + i] = 0.0;
        values[across.start + i * across.stride + direction] = 0.0;
      }
    }
    const auto own = matrix.find(block, block);
    values[own.start + direction * own.stride + direction] = diagonal;
  }
}

// Where flow goes on without resistance the matrix is singular, and a load that rises along the path with it: the least
// stiffness everywhere leaves the direction of the flow to the path's equation, and the forces are exact all the same.
Factors factorise_propped(const assembly::Model& model, assembly::BlockMatrix& matrix, LinearSolver& solver) {
  constexpr double kLeast = 1e-9;  // of the modulus: a condition of the matrix that the solution bears
  for (Index unknown = 0; unknown < model.unknowns.displacements(); ++unknown)
    matrix.add(matrix.find(unknown, unknown), kLeast * model.stiffness() * Mat2::Identity());
  return solver.factorise(matrix);
}

// Every traction that a constraint on a gap or slip decides makes one pivot negative; without those the determinant
// tells of the body.
Pivots pivots_of_body(const LinearSolver& solver, const assembly::Assembler& assembler) {
  Pivots out = solver.pivots();
  for (const auto& condition : assembler.multipliers().conditions())
    for (int row = 0; row < 2; ++row) out.negative_determinant ^= !(condition.by_own(row, row) > 0.0);
  return out;
}

// Whether the factors of the iteration before do once more. After a Newton step the error is of second order in that
// step: it took the residual from r1 to r2, and the same factors take it from r2 to about 2 r2^2 / r1.
bool old_factors_do(const std::vector<Iteration>& before, const Iteration& now, const NewtonControls& controls) {
  constexpr double kMargin = 0.1;  // a step that is not the last one was in vain
  const bool last = static_cast<int>(before.size()) + 1 >= controls.min_iterations;
  if (!last || before.empty() || before.back().kept || before.back().chatters) return false;
  if (now.status_changes + now.partner_changes > 0) return false;
  return 2.0 * now.residual * now.residual <= kMargin * controls.residual_tolerance * before.back().residual;
}

void move_boundary(const std::vector<assembly::Constraint>& constraints, const VecX& target, VecX& u, VecX& change) {
  for (std::size_t k = 0; k < constraints.size(); ++k) u[constraints[k].component] = target[k];
  change.setZero();
}

// Where hats still change late in an iteration: what settles them beside the correction du, unless a part that they let
// go would fly away.
std::optional<Correction> settle_contact(const assembly::Model& model, const assembly::History& history, const VecX& u,
                                         const VecX& du, double reach, assembly::Assembler& assembler,
                                         const Bordered& system) {
  auto out = contact_step(model, history, u, du, assembler, system);
  if (!out || !out->displacement.allFinite() || farthest(model, du + out->displacement) > reach) return std::nullopt;
  return out;
}

// Of a correction that cannot be made.
assembly::Failure useless(const assembly::Model& model, Factors factors, const VecX& du, bool finite) {
  using assembly::FailureKind;
  if (!finite)
    return {factors == Factors::Regular ? FailureKind::NotFinite : FailureKind::Singular, assembly::NoCorrection{}};
  const auto [component, size] = largest(du);
  return {FailureKind::Singular, assembly::FarCorrection{position_of(model, component), size}};
}

// A part that nothing but contact holds has left, correction by correction.
assembly::Failure left_behind(const assembly::Model& model, const VecX& moved) {
  const auto [component, size] = largest(moved);
  return {assembly::FailureKind::Singular, assembly::LostPart{position_of(model, component), size}};
}

}  // namespace

Increment solve_increment(const assembly::Model& model, const std::vector<assembly::Constraint>& constraints,
                          const assembly::State& state, const Goal& goal, const NewtonControls& controls,
                          assembly::Assembler& assembler, LinearSolver& solver, const IterationObserver& observer) {
  Increment out;
  const bool along_path = goal.stretch > 0.0;
  double& load = out.load;
  load = along_path ? state.load + goal.stretch * (state.load - state.previous_load) : goal.load;
  auto [dead, target] = prescription(model, constraints, load);
  if (goal.held) dead += *goal.held;
  const double modulus = model.stiffness();
  VecX& u = out.displacement;
  u = state.displacement;
  if (along_path)
    u += goal.stretch * (state.displacement - state.previous_displacement);
  else if (goal.guess)
    u = *goal.guess;
  else if (controls.extrapolate)
    out.extrapolated = predict(state, constraints, target, load, u);
  VecX change(target.size());
  for (std::size_t k = 0; k < constraints.size(); ++k) change[k] = target[k] - u[constraints[k].component];
  const double reach = extent_of(model.mesh) + (change.size() > 0 ? change.cwiseAbs().maxCoeff() : 0.0);
  if (model.is_linear()) move_boundary(constraints, target, u, change);

  ActiveSet active;
  Chatter chatter(controls.max_iterations);
  bool parts_held = false;
  double correction = std::numeric_limits<double>::infinity(), moves = correction;
  double first_residual = 0.0, last_residual = std::numeric_limits<double>::infinity();
  for (int i = 0;; ++i) {
    if (along_path && !(load > goal.lowest)) {
      out.failure = assembly::Failure{assembly::FailureKind::NoConvergence, assembly::LoadTooLow{goal.lowest}};
      return out;
    }
    Iteration it;
    const auto seconds = [&] {
      const auto& s = assembler.seconds();
      return s.bulk + s.contact + s.pattern;
    };
    const double assembly_before = seconds();
    if (auto failure = assembler.assemble(u, state.history)) {
      out.failure = failure;
      return out;
    }
    it.assembly_seconds = seconds() - assembly_before;
    const bool again = active.update(model, assembler, state.history, it);

    VecX rhs = dead - assembler.internal_force();
    double reactions = 0.0;
    for (const auto& c : constraints) {
      reactions += rhs[c.component] * rhs[c.component];
      rhs[c.component] = 0.0;
    }
    const ForceNorms forces{std::sqrt(reactions), dead.norm(), assembler.contact_force().norm()};
    const double scale = forces.scale();
    const RoundingFloor rounding = rounding_floor(model, u);
    const double floor = rounding.total();
    const Resolution resolution(rounding, forces, state.largest_force);
    const double residual = rhs.norm();
    it.residual = residual / std::max(scale, floor);
    it.rounding = floor / std::max(scale, floor);
    const bool in_place = change.size() == 0 || change.cwiseAbs().maxCoeff() == 0.0;
    if (residual > 0.0 && resolution.hidden_by_springs()) {
      out.failure =
          assembly::Failure{assembly::FailureKind::NoConvergence, assembly::RoundingOfSprings{rounding.contact, scale}};
      return out;
    }
    // theory (9.2)
    const bool settled =
        correction <= controls.correction_tolerance || modulus * moves <= controls.residual_tolerance * scale;
    if (in_place && i >= controls.min_iterations) {
      const bool converged = it.residual <= controls.residual_tolerance && settled;
      const double missing = resolution.missing(residual);
      const bool falls =
          missing > kUnnoticedResidual && residual < kStillFalls * last_residual && i < controls.max_iterations;
      const bool stays = residual <= kNearRounding * floor && residual >= kStillFalls * last_residual &&
                         it.status_changes + it.partner_changes == 0;
      if (converged || (residual <= floor && !falls) || stays) {
        out.left = it;
        out.force = scale;
        out.rounded = converged ? 0.0 : missing;
        if (!converged) out.failure = resolution.refuse(residual);
        return out;
      }
    }
    last_residual = residual;
    if (i <= 1) first_residual = std::max(first_residual, residual);  // a body at rest is in balance before it is moved
    chatter.look_at(i, it, again);
    if (chatter.is_over() || (i > 3 && residual > 1e8 * (first_residual + floor))) {
      out.failure = unbalanced(model, it, i, rhs, chatter.halved());
      return out;
    }

    if (solver.pattern() != assembler.pattern_version()) solver.new_pattern(assembler.pattern_version());
    it.kept = solver.has_factors() &&
              (model.is_linear() || (!along_path && in_place && old_factors_do(out.iterations, it, controls)));
    if (!it.kept) prescribe(constraints, change, modulus, assembler.matrix(), rhs);
    VecX by_load;
    if (along_path) {
      const Prescription rate = rate_of(model, constraints, load);
      by_load = rate.dead;
      prescribe(constraints, rate.displacement, modulus, assembler.matrix(), by_load);
    }
    if (!it.kept) eliminate(constraints, modulus, assembler.matrix());
    const auto& s = solver.seconds();
    const double before = s.analyse + s.factorise + s.solve;
    Factors factors = it.kept ? Factors::Regular : solver.factorise(assembler.matrix());
    if (along_path && factors == Factors::Doubtful) factors = factorise_propped(model, assembler.matrix(), solver);
    Bordered system(solver);
    VecX du;
    double change_of_load = 0.0;
    const auto take = [&](const Correction& c) {
      du += c.displacement;
      change_of_load += c.load;
    };
    if (factors != Factors::None) {
      if (factors == Factors::Regular) it.pivots = pivots_of_body(solver, assembler);
      if (along_path) system.follow(state.progress, by_load);
      du.setZero(u.size());
      take(system.solve(rhs));
      if (along_path) take(system.go_on(goal.stretch - state.progress.dot(u - state.displacement)));
    }
    it.factor_seconds = s.analyse + s.factorise + s.solve - before;
    const bool finite = factors != Factors::None && du.allFinite();
    const bool bounded = finite && largest(du).size <= (factors == Factors::Regular ? kFlewAway * reach : 0.0);
    if (factors != Factors::Regular || !bounded) {
      auto held = along_path || it.kept
                      ? std::nullopt
                      : correction_with_parts_held(model, constraints, rhs, reach, assembler.matrix(), solver);
      if (!held) {
        out.failure = useless(model, factors, du, finite);
        return out;
      }
      du = std::move(*held);
      parts_held = true;
    }
    if (in_place) {
      const bool late = chatter.struggles() && active.hats_change();
      if (const auto contact =
              late ? settle_contact(model, state.history, u, du, reach, assembler, system) : std::nullopt) {
        take(*contact);
      } else if (chatter.halves()) {
        du *= 0.5;
        change_of_load *= 0.5;
        it.chatters = true;
      }
    }
    if (along_path) {
      load += change_of_load;
      auto now = prescription(model, constraints, load);
      dead = std::move(now.dead);
      target = std::move(now.displacement);
    }
    u += du;
    move_boundary(constraints, target, u, change);
    const double moved = (u - state.displacement).cwiseAbs().maxCoeff();
    if (parts_held && farthest(model, u - state.displacement) > reach) {
      out.failure = left_behind(model, u - state.displacement);
      return out;
    }
    moves = du.cwiseAbs().maxCoeff();
    correction = moved > 0.0 ? moves / moved : 0.0;
    it.correction = correction;
    it.gradient = largest_gradient(model, du);
    it.energy = std::fabs(rhs.dot(du));
    out.iterations.push_back(it);
    if (observer) observer(i + 1, it);
  }
}

}  // namespace cleft::solve
