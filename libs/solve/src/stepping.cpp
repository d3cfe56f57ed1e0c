#include "cleft/solve/stepping.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "commit_contact.hpp"
#include "flow.hpp"
#include "path.hpp"
#include "prescription.hpp"
#include "targets.hpp"
#include "work_error.hpp"

namespace cleft::solve {
namespace {

constexpr double kCrumb = 1e-2;             // of the way to the next target: however short, it may be cut to this
constexpr std::size_t kEasyIterations = 5;  // an increment that took no more lets the next one grow
constexpr double kMayHaveJumped = 0.05;     // unexplained part of an increment that a shorter one replaces,
constexpr double kHasJumped = 0.2;          // and one that is no question of its length
constexpr double kShortForFlow = 1.0 / 16;  // of the planned increment: a shorter one may flow as far as it does
constexpr double kReaches = 1.0 + 2.5 * kGivesWay;  // times the wanted increment: no farther a target ends it

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

void LoadStepper::restore(assembly::State state, StepPlace place, std::optional<assembly::ContactRoom> room) {
  state_ = std::move(state);
  place_ = place;
  if (room) assembler_.set_room(std::move(*room));
}

// Whether the last increment tells how the next one will go.
bool LoadStepper::goes_on() const { return state_.previous_load < state_.load && !turns_at(controls_, state_.load); }

// Where the next increment of the load ends. No crumbs: what is left of the way to a target is either nothing or at
// least as long as the increment.
double LoadStepper::next_end(double before) const {
  const double target = first_beyond(targets_, state_.load), rest = target - state_.load;
  const double end = rest <= kReaches * place_.step ? target : state_.load + std::min(place_.step, 0.5 * rest);
  return std::min(before, end);
}

// What a path must not pass by.
double LoadStepper::next_mark() const { return first_beyond(marks_, place_.furthest); }

Increment LoadStepper::solve(const Goal& goal, const IterationObserver& observer) {
  state_.history.duration = goal.stretch > 0.0 ? constitutive::kForever : goal.load - state_.load;
  NewtonControls newton = controls_.newton;
  newton.extrapolate = newton.extrapolate && !turns_at(controls_, state_.load);
  const auto attempt = [&] {
    return solve_increment(model_, constraints_, state_, goal, newton, assembler_, solver_, observer);
  };
  Increment out = attempt();
  if (!out.failure || !out.extrapolated) return out;  // where contact changes the last increment is no guide
  newton.extrapolate = false;
  Increment again = attempt();
  return again.failure ? out : again;
}

// After a failure: false where there is nothing shorter to try.
bool LoadStepper::shorten(double taken, double least) {
  if (place_.stretch > 0.0) {
    place_.stretch *= 0.5;
    return is_longer(kShortest);
  }
  place_.step = 0.5 * taken;
  if (!knows_path()) return place_.step >= least;
  const double last = std::fabs(state_.load - state_.previous_load);
  place_.stretch = last > 0.0 ? std::min(place_.step / last, kLongest) : 1.0;
  place_.longest = last_motion(model_, state_);
  place_.plateau = {};
  return true;
}

// Part of its share of the largest energy that the last increment missed: what the trapezoidal rule makes of forces
// that bend against the increment before or, where that does not tell, what the energies leave unexplained.
double LoadStepper::missed_work(const assembly::State& before, bool goes_on) const {
  const double missed = goes_on ? trapezoidal_error(model_, constraints_, before, state_)
                                : std::fabs(state_.energies.imbalance() - before.energies.imbalance());
  const double share = (state_.load - before.load) / state_.load;
  return missed / (state_.energies.largest * share + std::numeric_limits<double>::min());
}

// theory (9.7): the increment that would have missed what the accuracy allows, with some caution.
double LoadStepper::fitting(double missed) const {
  constexpr double kCaution = 0.8;
  return kCaution * std::sqrt(controls_.accuracy / missed) * (state_.load - state_.previous_load);
}

// After an increment of the load that converged, which is committed already.
void LoadStepper::lengthen(bool easy, double fits) {
  const double taken = state_.load - state_.previous_load;
  place_.step = std::min(std::max(place_.step, easy ? 2.0 * taken : taken), std::max(planned(), fits));
}

// Nothing where the increment is longer than planned and misses too much: then it is wanted as short as it takes.
std::optional<Step> LoadStepper::commit_if_accurate(const Increment& increment, bool easy, bool goes_on) {
  std::optional<Step> out;
  if (controls_.accuracy == 0.0) {
    out = commit(increment);
    end_account();
    lengthen(easy, planned());
    return out;
  }
  const Committed before{state_, place_, pairs_};
  out = commit(increment);
  end_account();
  const double missed = missed_work(before.state, goes_on), fits = fitting(missed);
  if (missed <= controls_.accuracy || increment.load - before.state.load <= kReaches * planned()) {
    lengthen(easy, fits);
    return out;
  }
  go_back_to(before);
  place_.step = std::max(planned(), fits);
  return std::nullopt;
}

void LoadStepper::go_back_to(const Committed& before) {
  state_ = before.state;
  place_ = before.place;
  pairs_ = before.pairs;
}

// What ends the run: the failure of the last attempt and how small that was.
assembly::Failure LoadStepper::given_up(assembly::Failure failure, double load, double size) const {
  if (place_.stretch > 0.0)
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
std::optional<Step> LoadStepper::keep(const Increment& increment, bool easy, bool goes_on, Tries& tries) {
  const bool along_path = place_.stretch > 0.0, guarded = tries.led || (!tries.believes && is_guarded());
  const auto before = guarded ? std::optional(Committed{state_, place_, pairs_}) : std::nullopt;
  const assembly::Energies energies = state_.energies;
  auto out = along_path ? commit_on_path(increment, easy) : commit_if_accurate(increment, easy, goes_on);
  if (!out) return out;
  const double unexplained = unexplained_part(energies, state_.energies, rounding_of_energy());
  out->jumped = unexplained > kHasJumped;
  if (!guarded || unexplained <= (along_path ? kMayHaveJumped : kHasJumped)) return out;
  go_back_to(*before);
  if (!along_path && !tries.dropped) tries.dropped = place_;
  (void)try_again(increment.load - state_.load, tries);
  return std::nullopt;
}

std::variant<Step, assembly::Failure> LoadStepper::advance(const IterationObserver& observer, const Event& event) {
  if (auto end = end_of_path()) return *end;
  const bool known = goes_on();
  if (!known) place_.step = std::min(place_.step, planned());
  Tries tries;
  tries.least = std::min(controls_.min_step, kCrumb * std::min(planned(), interval_around(targets_, state_.load)));
  int iterations_before = 0;
  double before = event.before;
  for (;;) {
    const bool along_path = place_.stretch > 0.0;
    const double end = next_end(before), taken = end - state_.load, size = along_path ? place_.stretch : taken;
    Increment increment = along_path ? try_path(observer) : solve({end}, observer);
    if (!increment.failure) increment.failure = refuse(increment);
    if (increment.failure) {
      if (try_again(taken, tries)) continue;
      if (along_path && !tries.led) {
        tries.led = true;
        if (auto led = lead_by_load(observer)) increment = std::move(*led);
      }
      if (increment.failure) return given_up(*increment.failure, increment.load, size);
    }
    const double flow = along_path ? 0.0 : largest_flow(model_, state_.history.plastic, assembler_.plastic());
    if (flow > controls_.max_flow && taken > kShortForFlow * planned()) {
      iterations_before += static_cast<int>(increment.iterations.size());
      place_.step = 0.5 * taken;
      continue;
    }
    if (along_path && !(increment.load > lowest())) return led_back();
    if (event.judge)
      if (const auto lower =
              event.judge({model_, increment.load, increment.displacement, assembler_.plastic(), assembler_.pairs()})) {
        before = *lower;
        continue;
      }
    const bool easy = increment.iterations.size() <= kEasyIterations && tries.cuts == 0 && iterations_before == 0 &&
                      flow <= 0.5 * controls_.max_flow;
    const bool is_output = has_near(controls_.outputs, increment.load, kSameLoad) && increment.load > place_.furthest;
    std::optional<Step> out = keep(increment, easy, known, tries);
    if (!out) {
      iterations_before += static_cast<int>(increment.iterations.size());
      continue;
    }
    out->is_output = is_output;
    out->cuts = tries.cuts;
    out->iterations_before = iterations_before;
    return *out;
  }
}

std::variant<Step, assembly::Failure> LoadStepper::settle(const IterationObserver& observer) {
  constexpr double kLeastPart = 1.0 / 1024;
  const double unexplained = state_.energies.imbalance();
  if (auto failure = assembler_.assemble(state_.displacement, state_.history)) return *failure;
  VecX held = assembler_.internal_force() - dead_force(model_, state_.load);
  for (const auto& constraint : constraints_) held[constraint.component] = 0.0;
  int cuts = 0, iterations_before = 0;
  bool failed = false;  // since the last part
  for (double gone = 0.0, part = 1.0;;) {
    const double next = std::min(1.0, gone + part);
    const VecX still = (1.0 - next) / (1.0 - gone) * held;
    const Increment increment = solve({.load = state_.load, .held = &still}, observer);
    if (increment.failure) {
      ++cuts;
      failed = true;
      part *= 0.5;
      if (part >= kLeastPart) continue;
      assembly::Failure failure = *increment.failure;
      failure.attempt = assembly::HeldPart{state_.load, 1.0 - gone};
      return failure;
    }
    Step out = commit(increment);
    if (next < 1.0) {
      --place_.number;
      iterations_before += static_cast<int>(increment.iterations.size());
      held = still;
      gone = next;
      if (increment.iterations.size() <= kEasyIterations && !failed) part *= 2.0;
      failed = false;
      continue;
    }
    // theory (10.7)
    state_.energies.released += state_.energies.imbalance() - unexplained;
    end_account();
    out.cuts = cuts;
    out.iterations_before = iterations_before;
    return out;
  }
}

// Forces at rounding do work, too, where a body moves without strain: an imbalance below that tells nothing.
double LoadStepper::rounding_of_energy() const {
  constexpr double kRounding = 1e2 * std::numeric_limits<double>::epsilon();
  const double moved = farthest(model_, state_.displacement);
  return kRounding * model_.stiffness() * moved * moved;
}

void LoadStepper::end_account() { state_.energies.end_increment(rounding_of_energy()); }

Step LoadStepper::commit(const Increment& increment) {
  const double load = increment.load;
  pairs_ = assembler_.pairs();
  if (controls_.control == Control::Path)
    if (auto w = path_progress(model_, state_, increment.displacement, assembler_.plastic()); w.size() > 0)
      state_.progress = std::move(w);
  assembly::Energies& energies = state_.energies;
  energies.elastic = elastic_energy(model_, increment.displacement, assembler_.plastic());
  const auto work = plastic_dissipation(model_, increment.displacement, state_.history);
  energies.plastic_dissipation += work.plastic;
  energies.viscous_dissipation += work.viscous;
  state_.history.plastic = assembler_.plastic();
  commit_contact(model_, assembler_, state_.displacement, pairs_, state_.history, energies);

  const VecX force = assembler_.internal_force() - dead_force(model_, load);
  VecX prescribed(constraints_.size());
  for (std::size_t k = 0; k < constraints_.size(); ++k) {
    const Index c = constraints_[k].component;
    prescribed[k] = force[c];
    energies.external_work +=
        0.5 * (prescribed[k] + state_.prescribed_force[k]) * (increment.displacement[c] - state_.displacement[c]);
  }
  energies.external_work +=
      0.5 *
      (dead_force(model_, load) + dead_force(model_, state_.load)).dot(increment.displacement - state_.displacement);

  state_.previous_prescribed_force = std::move(state_.prescribed_force);
  state_.prescribed_force = prescribed;
  state_.largest_force = std::max(state_.largest_force, increment.force);
  state_.previous_load = state_.load;
  state_.previous_displacement = std::move(state_.displacement);
  state_.load = load;
  place_.furthest = std::max(place_.furthest, load);
  state_.displacement = increment.displacement;
  return {.number = ++place_.number,
          .load = load,
          .iterations = increment.iterations,
          .left = increment.left,
          .rounded = increment.rounded};
}

std::vector<Vec2> LoadStepper::reactions() const {
  return reactions_(model_, constraints_, state_.prescribed_force, state_);
}

}  // namespace cleft::solve
