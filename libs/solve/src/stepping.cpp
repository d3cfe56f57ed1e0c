#include "cleft/solve/stepping.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "arc_length.hpp"
#include "commit.hpp"
#include "flow.hpp"
#include "prescription.hpp"
#include "targets.hpp"

namespace cleft::solve {
namespace {

constexpr double kMayHaveJumped = 0.05;     // unexplained part of an increment that a shorter one replaces,
constexpr double kHasJumped = 0.2;          // and one that is no question of its length
constexpr double kShortForFlow = 1.0 / 16;  // of the planned increment: a shorter one may flow as far as it does
constexpr double kLeastOfWay = 1e-2;        // to the next target: however short that is, it may be cut to this

FailedAttempt attempt_of(const Increment& failed) {
  FailedAttempt out{failed.load, failed.iterations};
  if (failed.left.residual > 0.0) out.iterations.push_back(failed.left);
  return out;
}

}  // namespace

Factorisation LoadStepper::factorisation_for(const assembly::Model& model) {
  return model.has_contact() || !model.has_symmetric_stress() ? Factorisation::Unsymmetric : Factorisation::Symmetric;
}

LoadStepper::LoadStepper(const assembly::Model& model, StepControls controls)
    : model_(model),
      controls_(std::move(controls)),
      constraints_(constraints_of(model)),
      reactions_(model, constraints_),
      marks_(marks_of(controls_)),
      targets_(targets_of(controls_, marks_)),
      assembler_(model),
      solver_(factorisation_for(model)),
      state_(state_at_rest(model)) {
  place_.step = planned();
  if (controls_.control == Control::Path)
    std::ranges::copy_if(controls_.kinks, std::back_inserter(path_ends_),
                         [&](double kink) { return turns_back(model_, constraints_, kink); });
}

void LoadStepper::restore(assembly::State state, StepPlace place, std::optional<assembly::ReservedCouplings> reserved) {
  state_ = std::move(state);
  place_ = place;
  if (reserved) assembler_.reserve(std::move(*reserved));
}

Increment LoadStepper::solve(const Goal& goal, const IterationObserver& observer) {
  state_.history.duration = goal.arc_increment > 0.0 ? constitutive::kForever : goal.load - state_.load;
  NewtonControls newton = controls_.newton;
  newton.extrapolate = newton.extrapolate && !turns_at(controls_, state_.load);
  const auto once = [&] {
    Increment out = solve_increment({model_, constraints_, state_, newton, assembler_, solver_, observer}, goal);
    if (out.failure) failed_attempts_.push_back(attempt_of(out));
    return out;
  };
  Increment out = once();
  if (!out.failure || !out.extrapolated) return out;  // where contact changes the last increment is no guide
  newton.extrapolate = false;
  Increment again = once();
  return again.failure ? out : again;
}

void LoadStepper::go_back_to(const Committed& before) {
  state_ = before.state;
  place_ = before.place;
  pairs_ = before.pairs;
}

// What ends the run: the failure of the last attempt and how small that was.
assembly::Failure LoadStepper::given_up(assembly::Failure failure, double load, double size) const {
  if (place_.arc_increment > 0.0)
    failure.attempt =
        assembly::LastArc{state_.load, place_.furthest, size * last_motion(model_, state_) / place_.longest};
  else
    failure.attempt = assembly::LastIncrement{load, state_.load, size, controls_.control == Control::Load};
  return failure;
}

// Whether there is anything left to try after a failure: something shorter or, after all, what seemed to jump.
bool LoadStepper::try_again(double taken, Tries& tries) {
  ++tries.cuts;
  if (shorten(taken, tries.least)) return true;
  if (!tries.dropped) return false;
  place_ = *std::exchange(tries.dropped, std::nullopt);
  tries.believes = true;
  return true;
}

// Commits an increment unless it is inaccurate or has jumped; then what is to be tried instead is known.
std::optional<Step> LoadStepper::keep(const Increment& increment, double flow, Tries& tries) {
  const bool along_path = place_.arc_increment > 0.0, guarded = tries.led || (!tries.believes && is_guarded());
  const auto before = guarded ? std::optional(Committed{state_, place_, pairs_}) : std::nullopt;
  const assembly::Energies energies = state_.energies;
  const Effort effort = effort_of(increment, flow, tries);
  std::optional<Step> out =
      along_path ? commit_on_path(increment, effort) : commit_if_accurate(increment, effort, tries.guide);
  if (!out) return out;
  const double unexplained =
      unexplained_part(energies, state_.energies, rounding_of_energy(model_, state_.displacement));
  out->jumped = unexplained > kHasJumped;
  if (!guarded || unexplained <= (along_path ? kMayHaveJumped : kHasJumped)) return out;
  go_back_to(*before);
  if (!along_path && !tries.dropped) tries.dropped = place_;
  (void)try_again(increment.load - state_.load, tries);
  return std::nullopt;
}

LoadStepper::Effort LoadStepper::effort_of(const Increment& increment, double flow, const Tries& tries) const {
  const bool easy = is_easy(increment) && tries.cuts == 0 && tries.iterations == 0 && flow <= 0.5 * controls_.max_flow;
  return easy ? Effort::Little : Effort::Much;
}

LoadStepper::Tries LoadStepper::first_try(const Event& event) {
  Tries out;
  out.guide =
      state_.previous_load < state_.load && !turns_at(controls_, state_.load) ? Guide::LastIncrement : Guide::None;
  if (out.guide == Guide::None) place_.step = std::min(place_.step, planned());
  out.least = std::min(controls_.min_step, kLeastOfWay * std::min(planned(), interval_around(targets_, state_.load)));
  out.before = event.before;
  return out;
}

LoadStepper::Attempt LoadStepper::attempt(const Tries& tries, const IterationObserver& observer) {
  const double end = next_end(tries.before);
  Attempt out{.along_path = place_.arc_increment > 0.0, .taken = end - state_.load};
  out.size = out.along_path ? place_.arc_increment : out.taken;
  out.increment = out.along_path ? try_path(observer) : solve({end}, observer);
  if (!out.increment.failure) out.increment.failure = refuse(out.increment);
  if (!out.increment.failure && !out.along_path)
    out.flow = largest_flow(model_, state_.history.plastic, assembler_.plastic());
  return out;
}

// Whether an increment that has converged is to be replaced by a shorter one: cells flow too far in it, or an event is
// to end it.
bool LoadStepper::is_too_long(const Attempt& tried, const Event& event, Tries& tries) {
  const Increment& increment = tried.increment;
  if (tried.flow > controls_.max_flow && tried.taken > kShortForFlow * planned()) {
    tries.iterations += static_cast<int>(increment.iterations.size());
    place_.step = 0.5 * tried.taken;
    return true;
  }
  if (!event.judge) return false;
  const auto lower =
      event.judge({model_, increment.load, increment.displacement, assembler_.plastic(), assembler_.pairs()});
  if (lower) tries.before = *lower;
  return lower.has_value();
}

std::variant<Step, assembly::Failure> LoadStepper::advance(const IterationObserver& observer, const Event& event) {
  failed_attempts_.clear();
  if (auto end = end_of_path()) return *end;
  Tries tries = first_try(event);
  for (;;) {
    Attempt tried = attempt(tries, observer);
    Increment& increment = tried.increment;
    if (increment.failure && try_again(tried.taken, tries)) continue;
    if (increment.failure && tried.along_path) lead_by_load(increment, tries, observer);
    if (increment.failure) return given_up(*increment.failure, increment.load, tried.size);
    if (tried.along_path && !(increment.load > lowest())) return led_back();
    if (is_too_long(tried, event, tries)) continue;
    const bool is_output =
        has_near(controls_.outputs, increment.load, kLoadResolution) && increment.load > place_.furthest;
    if (auto out = keep(increment, tried.flow, tries)) {
      out->is_output = is_output;
      out->cuts = tries.cuts;
      out->iterations_before = tries.iterations;
      return *out;
    }
    tries.iterations += static_cast<int>(increment.iterations.size());
  }
}

Step LoadStepper::commit(const Increment& increment) {
  pairs_ = assembler_.pairs();
  if (controls_.control == Control::Path)
    if (auto w = path_progress(model_, state_, increment.displacement, assembler_.plastic()); w.size() > 0)
      state_.progress = std::move(w);
  commit_increment({model_, constraints_, assembler_, increment}, state_);
  place_.furthest = std::max(place_.furthest, increment.load);
  return {.number = ++place_.number,
          .load = increment.load,
          .iterations = increment.iterations,
          .left = increment.left,
          .rounded = increment.rounded};
}

void LoadStepper::end_account() { state_.energies.end_increment(rounding_of_energy(model_, state_.displacement)); }

std::vector<Vec2> LoadStepper::reactions() const {
  return reactions_(model_, constraints_, state_.prescribed_force, state_);
}

}  // namespace cleft::solve
