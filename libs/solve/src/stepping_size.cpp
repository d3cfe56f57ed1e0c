// The part of the stepper that chooses how long increments of the load are.
#include <algorithm>
#include <cmath>
#include <limits>

#include "arc_length.hpp"
#include "cleft/solve/stepping.hpp"
#include "targets.hpp"
#include "work_error.hpp"

namespace cleft::solve {
namespace {

constexpr std::size_t kEasyIterations = 5;          // an increment that took no more lets the next one grow
constexpr double kReaches = 1.0 + 2.5 * kGivesWay;  // times the wanted increment: no farther a target ends it

}  // namespace

bool LoadStepper::is_easy(const Increment& increment) { return increment.iterations.size() <= kEasyIterations; }

// Where the next increment of the load ends. No crumbs: what is left of the way to a target is either nothing or at
// least as long as the increment.
double LoadStepper::next_end(double before) const {
  const double target = first_beyond(targets_, state_.load), rest = target - state_.load;
  const double end = rest <= kReaches * place_.step ? target : state_.load + std::min(place_.step, 0.5 * rest);
  return std::min(before, end);
}

// What a path must not pass by.
double LoadStepper::next_mark() const { return first_beyond(marks_, place_.furthest); }

// After a failure: false where there is nothing shorter to try.
bool LoadStepper::shorten(double taken, double least) {
  if (place_.arc_increment > 0.0) {
    place_.arc_increment *= 0.5;
    return is_longer(kShortest);
  }
  place_.step = 0.5 * taken;
  if (!knows_path()) return place_.step >= least;
  const double last = std::fabs(state_.load - state_.previous_load);
  place_.arc_increment = last > 0.0 ? std::min(place_.step / last, kLongest) : 1.0;
  place_.longest = last_motion(model_, state_);
  place_.plateau = {};
  return true;
}

// Part of its share of the largest energy that the last increment missed: what the trapezoidal rule makes of forces
// that bend against the increment before or, where that is no guide, what the energies leave unexplained.
double LoadStepper::missed_work(const assembly::State& before, Guide guide) const {
  const double missed = guide == Guide::LastIncrement
                            ? trapezoidal_error(model_, constraints_, before, state_)
                            : std::fabs(state_.energies.imbalance() - before.energies.imbalance());
  const double share = (state_.load - before.load) / state_.load;
  return missed / (state_.energies.largest * share + std::numeric_limits<double>::min());
}

// theory (9.7): the increment that would have missed what the accuracy allows, with some caution.
double LoadStepper::fitting(double missed) const {
  constexpr double kCaution = 0.8;
  return kCaution * std::sqrt(controls_.accuracy / missed) * (state_.load - state_.previous_load);
}

// After an increment of the load that converged, which is committed already; `fits`: the longest that may follow.
void LoadStepper::lengthen(Effort effort, double fits) {
  const double taken = state_.load - state_.previous_load;
  const double easily = effort == Effort::Little ? 2.0 * taken : taken;
  place_.step = std::min(std::max(place_.step, easily), std::max(planned(), fits));
}

// Nothing where the increment is longer than planned and misses too much: then it is wanted as short as it takes.
std::optional<Step> LoadStepper::commit_if_accurate(const Increment& increment, Effort effort, Guide guide) {
  std::optional<Step> out;
  if (controls_.accuracy == 0.0) {
    out = commit(increment);
    end_account();
    lengthen(effort, planned());
    return out;
  }
  const Committed before{state_, place_, pairs_};
  out = commit(increment);
  end_account();
  const double missed = missed_work(before.state, guide), fits = fitting(missed);
  if (missed <= controls_.accuracy || increment.load - before.state.load <= kReaches * planned()) {
    lengthen(effort, fits);
    return out;
  }
  go_back_to(before);
  place_.step = std::max(planned(), fits);
  return std::nullopt;
}

}  // namespace cleft::solve
