#include "cleft/solve/newton.hpp"

#include <algorithm>
#include <cmath>

#include "boundary_values.hpp"
#include "largest_residual.hpp"
#include "newton_failures.hpp"
#include "newton_iteration.hpp"
#include "prediction.hpp"

namespace cleft::solve {
namespace {

// A residual at the level of rounding that users would notice ends the iteration once it no longer falls to this part
// of the one before: the level is but an estimate.
constexpr double kStillFalls = 0.5;

// A residual that no longer falls is rounding, too, up to this many times the level: the solution of the equations has
// errors of its own, as on needles.
constexpr double kNearRounding = 100.0;

// Times the first residual: one that has grown as much diverges. Not at once: the first corrections may overshoot.
constexpr double kDiverges = 1e8;
constexpr int kMayOvershoot = 3;  // iterations

double extent_of(const geometry::Mesh& mesh) {
  const auto [low, high] = geometry::box_around(mesh);
  return (high - low).norm();
}

double total(const assembly::AssemblySeconds& s) { return s.bulk + s.contact + s.pattern; }

}  // namespace

Increment NewtonIteration::run() {
  begin();
  for (;; ++number_) {
    Iteration it;
    if (auto failure = evaluate(it)) return failed(std::move(*failure));
    const Balance balance = weigh(it);
    out_.left = it;
    if (auto failure = balance.resolution.refuse_springs(balance.residual)) return failed(std::move(*failure));
    if (const Verdict verdict = judge(it, balance); verdict != Verdict::Continue) return finish(balance, verdict);
    if (diverges(it, balance)) return failed(unbalanced(model_, it, number_, rhs_, cycling_.halved()));
    if (auto failure = step(it)) return failed(std::move(*failure));
    out_.iterations.push_back(it);
    out_.left = {};
    if (problem_.observer) problem_.observer(number_ + 1, it);
  }
}

void NewtonIteration::begin() {
  const auto& constraints = problem_.constraints;
  out_.load = along_path() ? state_.load + goal_.arc_increment * (state_.load - state_.previous_load) : goal_.load;
  wanted_ = prescription(model_, constraints, out_.load);
  if (goal_.held) wanted_.dead += *goal_.held;
  VecX& u = out_.displacement;
  u = state_.displacement;
  if (along_path()) {
    u += goal_.arc_increment * (state_.displacement - state_.previous_displacement);
  } else if (goal_.guess) {
    u = *goal_.guess;
  } else if (problem_.controls.extrapolate) {
    auto guess = continued(state_, constraints, wanted_.displacement, out_.load);
    out_.extrapolated = guess.has_value();
    if (guess) u = std::move(*guess);
  }
  change_ = missing_motion(constraints, wanted_.displacement, u);
  reach_ = extent_of(model_.mesh) + (change_.size() > 0 ? change_.cwiseAbs().maxCoeff() : 0.0);
  if (model_.is_linear()) move_boundary(constraints, wanted_.displacement, u, change_);
}

// Forces, tangent and active set at the iterate.
std::optional<assembly::Failure> NewtonIteration::evaluate(Iteration& it) {
  if (along_path() && !(out_.load > goal_.lowest))
    return assembly::Failure{assembly::FailureKind::NoConvergence, assembly::LoadTooLow{goal_.lowest}};
  const double before = total(assembler_.seconds());
  if (auto failure = assembler_.assemble(out_.displacement, state_.history)) return failure;
  it.assembly_seconds = total(assembler_.seconds()) - before;
  returns_ = active_.update(model_, assembler_, state_.history, out_.displacement, it);
  return std::nullopt;
}

Balance NewtonIteration::weigh(Iteration& it) {
  rhs_ = wanted_.dead - assembler_.internal_force();
  double reactions = 0.0;
  for (const auto& c : problem_.constraints) {
    reactions += rhs_[c.component] * rhs_[c.component];
    rhs_[c.component] = 0.0;
  }
  const ForceNorms forces{std::sqrt(reactions), wanted_.dead.norm(), assembler_.contact_force().norm()};
  const RoundingFloor rounding = rounding_floor(model_, out_.displacement);
  const Balance out{rhs_.norm(), forces.scale(), rounding.total(), {rounding, forces, state_.largest_force}};
  it.residual = out.residual / std::max(out.scale, out.floor);
  it.rounding = out.floor / std::max(out.scale, out.floor);
  it.largest = largest_residual(model_, assembler_, state_.history, rhs_);
  return out;
}

// theory (9.2)
Verdict NewtonIteration::judge(const Iteration& it, const Balance& balance) const {
  const NewtonControls& controls = problem_.controls;
  if (!is_boundary_in_place() || number_ < controls.min_iterations) return Verdict::Continue;
  const bool settled = correction_ <= controls.correction_tolerance ||
                       model_.stiffness() * moved_ <= controls.residual_tolerance * balance.scale;
  if (it.residual <= controls.residual_tolerance && settled) return Verdict::Converged;
  const bool fell = balance.residual < kStillFalls * last_residual_;
  const bool may_fall =
      fell && balance.resolution.missing(balance.residual) > kUnnoticedResidual && number_ < controls.max_iterations;
  const bool stays = balance.residual <= kNearRounding * balance.floor &&
                     balance.residual >= kStillFalls * last_residual_ && it.status_changes + it.partner_changes == 0;
  return (balance.residual <= balance.floor && !may_fall) || stays ? Verdict::EndedByRounding : Verdict::Continue;
}

Increment NewtonIteration::finish(const Balance& balance, Verdict verdict) {
  out_.force = balance.scale;
  if (verdict == Verdict::EndedByRounding) {
    out_.rounded = balance.resolution.missing(balance.residual);
    out_.failure = balance.resolution.refuse(balance.residual);
  }
  return std::move(out_);
}

bool NewtonIteration::diverges(const Iteration& it, const Balance& balance) {
  last_residual_ = balance.residual;
  if (number_ <= 1)  // a body at rest is in balance before it is moved
    first_residual_ = std::max(first_residual_, balance.residual);
  cycling_.look_at(number_, it, returns_);
  return cycling_.is_over() ||
         (number_ > kMayOvershoot && balance.residual > kDiverges * (first_residual_ + balance.floor));
}

Increment solve_increment(const NewtonProblem& problem, const Goal& goal) {
  return NewtonIteration(problem, goal).run();
}

}  // namespace cleft::solve
