// The part of the stepper that follows a path.
#include <algorithm>
#include <cmath>
#include <utility>

#include "arc_length.hpp"
#include "cleft/solve/stepping.hpp"
#include "prescription.hpp"
#include "targets.hpp"
#include "tunnelling.hpp"

namespace cleft::solve {
namespace {

constexpr double kJumpsNot = 1.0 / 64;  // of the longest increment so far: one so short is believed wherever it lands
constexpr double kRises = 0.5;          // of the planned increment: the load's gain that ends a path
constexpr int kMostWandered = 1000, kWanders = 20;  // increments below the largest load, and times those planned

bool any_slips(const std::vector<contact::Pair>& pairs) {
  return std::ranges::any_of(
      pairs, [](const contact::Pair& pair) { return pair.state.traction.status == contact::Status::Slip; });
}

}  // namespace

// Where a path ends: below it the loads do not change, or otherwise.
double LoadStepper::lowest() const {
  double out = 0.0;
  for (const double end : path_ends_)
    if (end < state_.load) out = std::max(out, end);
  return out;
}

Increment LoadStepper::try_path(const IterationObserver& observer) {
  Increment increment = solve({.arc_increment = place_.arc_increment, .lowest = lowest()}, observer);
  if (increment.failure && !(increment.load > lowest()) && state_.load < state_.previous_load) {
    Increment at_end = solve({lowest()}, observer);  // where the path gets there, and not by going back the way it came
    if (!at_end.failure && state_.progress.dot(at_end.displacement - state_.displacement) > 0.0) return at_end;
  }
  const double mark = next_mark();
  if (increment.failure || increment.load <= mark) return increment;
  const double part = (mark - state_.load) / (increment.load - state_.load);
  const VecX guess = state_.displacement + part * (increment.displacement - state_.displacement);
  return solve({.load = mark, .guess = &guess}, observer);
}

// Past a kink of the path, as where a point of contact opens, its coordinate may have to go back: then the load leads,
// the way that it went, once. Replaces the increment that failed if that finds one.
void LoadStepper::lead_by_load(Increment& increment, Tries& tries, const IterationObserver& observer) {
  if (std::exchange(tries.led, true)) return;
  const double way = state_.load > state_.previous_load ? 1.0 : -1.0;
  for (double part = 1.0 / 16.0; part > kShortest; part *= 0.125) {
    Increment out = solve({.load = state_.load + way * part * planned()}, observer);
    if (!out.failure) out.failure = refuse(out);
    if (out.failure || !(out.load <= next_mark())) continue;
    increment = std::move(out);
    return;
  }
}

// From a kink the path leads no one knows where, and nowhere in a hold.
bool LoadStepper::knows_path() const {
  return controls_.control == Control::Path && !model_.is_linear() && state_.progress.size() > 0 &&
         !turns_at(controls_, state_.load) && changes(rate_of(model_, constraints_, state_.load));
}

// Whether the next increment along the path is longer than this part of the longest so far.
bool LoadStepper::is_longer(double part) const {
  return place_.arc_increment * last_motion(model_, state_) >= part * place_.longest;
}

// Whether the increment at hand is dropped where it has jumped to another branch: on a path while a shorter one might
// not jump. Where faces begin to slip at a turn of the load, energy is missing however short the increment is.
bool LoadStepper::is_guarded() const {
  if (place_.arc_increment > 0.0) return is_longer(kJumpsNot);
  const bool turns = turns_at(controls_, state_.load) && any_slips(assembler_.pairs());
  return controls_.control == Control::Path && !model_.is_linear() && !turns;
}

// How many times as long an increment along the path was wanted as the one that ends at a mark.
double LoadStepper::cut_short(const Increment& increment) const {
  if (increment.load != next_mark()) return 1.0;
  const double made = state_.progress.dot(increment.displacement - state_.displacement);
  return made > 0.0 ? std::min(place_.arc_increment / made, kLongest) : 1.0;
}

Step LoadStepper::commit_on_path(const Increment& increment, Effort effort) {
  const double wanted = cut_short(increment);
  Step out = commit(increment);
  end_account();
  const double gain = state_.load - state_.previous_load, moved = last_motion(model_, state_);
  place_.longest = std::max(place_.longest, moved);
  place_.plateau.follow(state_.load, moved, farthest(model_, state_.displacement));
  place_.wandered = state_.load < place_.furthest ? place_.wandered + 1 : 0;
  const bool easy = effort == Effort::Little;
  if (turns_at(controls_, state_.load) || (easy && gain >= kRises * planned())) {
    place_.arc_increment = 0.0;
    place_.step = std::clamp(gain, kRises * planned(), planned());
    return out;
  }
  place_.arc_increment = std::max(easy ? 2.0 : 1.0, wanted);
  if (gain != 0.0) place_.arc_increment = std::min(place_.arc_increment, planned() / std::fabs(gain));
  return out;
}

// Why an increment that converged is none of the path.
std::optional<assembly::Failure> LoadStepper::refuse(const Increment& increment) const {
  if (auto lost = tunnelling(model_, state_.history, increment.displacement, pairs_, assembler_.pairs())) return lost;
  if (place_.arc_increment == 0.0 || increment.iterations.empty()) return std::nullopt;
  const auto& pivots = increment.iterations.back().pivots;
  const auto determinant =
      pivots && !pivots->negative_determinant ? Determinant::Positive : Determinant::NegativeOrUnknown;
  if (any_slips(assembler_.pairs())) return std::nullopt;
  if (!unloads_elastically(state_, assembler_.plastic(), increment.load, determinant)) return std::nullopt;
  return assembly::Failure{assembly::FailureKind::Unloads};
}

// The path's end where nothing but flow or sliding goes on, and where it wanders among loads that it has seen.
std::optional<assembly::Failure> LoadStepper::end_of_path() const {
  const assembly::PathEnd end{place_.furthest, place_.wandered};
  if (place_.plateau.goes_on()) return assembly::Failure{assembly::FailureKind::Plateau, end};
  if (place_.wandered > std::max(kMostWandered, kWanders * controls_.steps))
    return assembly::Failure{assembly::FailureKind::Wanders, end};
  return std::nullopt;
}

// Where an increment has come back to what the path began with, or to where an amplitude turned.
assembly::Failure LoadStepper::led_back() const {
  return {lowest() > 0.0 ? assembly::FailureKind::LedBack : assembly::FailureKind::Unloaded,
          assembly::PathBack{state_.load, lowest()}};
}

}  // namespace cleft::solve
