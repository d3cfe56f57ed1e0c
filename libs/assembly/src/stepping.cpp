#include "cleft/assembly/stepping.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "cleft/contact/history.hpp"
#include "lost_contact.hpp"
#include "path.hpp"

namespace cleft::assembly {
namespace {

constexpr double kSameLoad = 1e-12;
constexpr double kCrumb = 1e-2;             // of the planned increment: however short that is, it may be cut to this
constexpr std::size_t kEasyIterations = 5;  // an increment that took no more lets the next one grow
constexpr double kShortest = 1.0 / 4096;    // along the path, of the last increment
constexpr double kRises = 0.5;              // of the planned increment: the load's gain that ends a path

std::vector<double> targets_of(const StepControls& controls) {
  std::vector<double> all(controls.outputs);
  const bool free = controls.accuracy > 0.0;
  if (free) all.insert(all.end(), controls.kinks.begin(), controls.kinks.end());
  const int equal = free ? 1 : controls.steps;
  for (int k = 1; k <= equal; ++k) all.push_back(static_cast<double>(k) / equal);
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end(), [](double a, double b) { return b - a < kSameLoad; }), all.end());
  all.back() = 1.0;
  return all;
}

}  // namespace

Factorisation LoadStepper::factorisation_for(const Model& model) {
  return model.has_contact() || !model.has_symmetric_stress() || !model.mate.empty() ? Factorisation::Unsymmetric
                                                                                     : Factorisation::Symmetric;
}

LoadStepper::LoadStepper(const Model& model, StepControls controls)
    : model_(model),
      controls_(std::move(controls)),
      constraints_(constraints_of(model)),
      targets_(targets_of(controls_)),
      assembler_(model),
      solver_(factorisation_for(model)),
      state_(state_at_rest(model)) {
  place_.step = 1.0 / controls_.steps;
  controls_.min_step = std::min(controls_.min_step, kCrumb * place_.step);
}

void LoadStepper::restore(State state, StepPlace place, std::optional<ContactRoom> room) {
  state_ = std::move(state);
  place_ = place;
  if (room) assembler_.set_room(std::move(*room));
}

double LoadStepper::next_target() const {
  const auto at = std::upper_bound(targets_.begin(), targets_.end(), state_.load + kSameLoad);
  return at == targets_.end() ? 1.0 : *at;
}

double LoadStepper::next_output() const {
  const auto at = std::upper_bound(controls_.outputs.begin(), controls_.outputs.end(), place_.furthest + kSameLoad);
  return at == controls_.outputs.end() ? 1.0 : *at;
}

Increment LoadStepper::solve(const Goal& goal, const IterationObserver& observer) {
  state_.history.duration = goal.stretch > 0.0 ? constitutive::kForever : goal.load - state_.load;
  return solve_increment(model_, constraints_, state_, goal, controls_.newton, assembler_, solver_, observer);
}

Increment LoadStepper::try_load(double before, const IterationObserver& observer) {
  if (before <= std::min(next_target(), state_.load + place_.step)) return solve({before}, observer);
  const double target = next_target();
  const double rest = target - state_.load;
  // no crumbs: what is left after this increment is either nothing or at least as large
  place_.step = rest <= place_.step * (1.0 + 1e-9) ? rest : std::min(place_.step, 0.5 * rest);
  return solve({place_.step == rest ? target : state_.load + place_.step}, observer);
}

Increment LoadStepper::try_path(const IterationObserver& observer) {
  Increment increment = solve({.stretch = place_.stretch}, observer);
  if (increment.failure && !(increment.load > 0.0) && state_.load < state_.previous_load) {
    Increment at_zero = solve({0.0}, observer);  // where the path gets there, and not by going back the way it came
    if (!at_zero.failure && state_.progress.dot(at_zero.displacement - state_.displacement) > 0.0) return at_zero;
  }
  if (increment.failure || increment.load <= next_output()) return increment;
  return solve({next_output()}, observer);
}

// After a failure: false where there is nothing shorter to try.
bool LoadStepper::shorten() {
  if (place_.stretch > 0.0) {
    place_.stretch *= 0.5;
    return place_.stretch >= kShortest;
  }
  place_.step *= 0.5;
  if (controls_.control == Control::Path && state_.progress.size() > 0) {
    const double last = std::fabs(state_.load - state_.previous_load);
    place_.stretch = last > 0.0 ? std::clamp(place_.step / last, 2.0 * kShortest, 1.0) : 1.0;
    return true;
  }
  return place_.step >= controls_.min_step;
}

// Part of the largest energy that the last increment left unexplained, over its share of the load.
double LoadStepper::missed_work(const Energies& before) const {
  const double missed = std::fabs(state_.energies.imbalance() - before.imbalance());
  const double share = (state_.load - state_.previous_load) / state_.load;
  return missed / (state_.energies.largest * share + std::numeric_limits<double>::min());
}

// After an increment that converged, which is committed already.
void LoadStepper::lengthen(bool easy, double missed) {
  const double planned = 1.0 / controls_.steps;
  if (place_.stretch == 0.0) {
    const double regained = easy ? std::min(2.0 * place_.step, planned) : std::min(place_.step, planned);
    if (controls_.accuracy > 0.0) {
      // theory (9.6): what the trapezoidal rule misses is of second order in the increment
      constexpr double kCaution = 0.8;
      const double fits = kCaution * std::sqrt(controls_.accuracy / std::max(missed, 1e-3 * controls_.accuracy));
      const double taken = state_.load - state_.previous_load;
      place_.step = std::max(regained, taken * std::clamp(fits, 0.5, easy ? 2.0 : 1.0));
    } else {
      place_.step = regained;
    }
    return;
  }
  const double gain = state_.load - state_.previous_load;
  if (easy && gain >= kRises * planned) {
    place_.stretch = 0.0;
    place_.step = std::min(gain, planned);
    return;
  }
  place_.stretch = easy ? 2.0 : 1.0;
  if (gain != 0.0) place_.stretch = std::min(place_.stretch, planned / std::fabs(gain));
}

// What ends the run: the failure of the last attempt and how small that was.
Failure LoadStepper::given_up(Failure failure, double load, double size) const {
  const std::string place = failure.place.empty() ? "" : failure.place + ", ";
  failure.place = place_.stretch > 0.0
                      ? fmt::format("{}on the path from load {:.6g}, increments down to {:.1e} of the last", place,
                                    state_.load, size)
                      : fmt::format("{}at load {:.6g} (last converged: {:.6g}), increments down to {:.1e}", place, load,
                                    state_.load, size);
  if (model_.has_memory() && controls_.control == Control::Load)
    failure.advice +=
        "; the body may be at a limit load: loading.control = \"path\" goes beyond it, material.viscosity "
        "delays flow that localises";
  return failure;
}

std::variant<Step, Failure> LoadStepper::advance(const IterationObserver& observer, const Event& event) {
  int cuts = 0;
  double before = event.before;
  for (;;) {
    const bool along_path = place_.stretch > 0.0;
    Increment increment = along_path ? try_path(observer) : try_load(before, observer);
    if (!increment.failure)
      increment.failure = lost_contact(model_, state_.history, increment.displacement, pairs_, assembler_.pairs());
    if (increment.failure) {
      const double size = along_path ? place_.stretch : place_.step;
      ++cuts;
      if (!along_path && before < state_.load + place_.step) place_.step = before - state_.load;
      if (shorten()) continue;
      return given_up(*increment.failure, increment.load, size);
    }
    if (!(increment.load > 0.0))
      return Failure{FailureKind::Unloaded, fmt::format("from load {:.6g}", state_.load),
                     "a finer mesh, hardening, or another measure of the load: nothing can bear it any more"};
    if (event.judge)
      if (const auto lower =
              event.judge({model_, increment.load, increment.displacement, assembler_.plastic(), assembler_.pairs()})) {
        before = *lower;
        continue;
      }
    const bool is_output = std::any_of(controls_.outputs.begin(), controls_.outputs.end(),
                                       [&](double l) { return std::fabs(l - increment.load) < kSameLoad; });
    const bool first_time = increment.load > place_.furthest;
    const Energies before_it = state_.energies;
    Step out = commit(increment);
    end_account();
    lengthen(increment.iterations.size() <= kEasyIterations && cuts == 0, missed_work(before_it));
    out.is_output = is_output && first_time;
    out.cuts = cuts;
    return out;
  }
}

std::variant<Step, Failure> LoadStepper::settle(const IterationObserver& observer) {
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
      Failure failure = *increment.failure;
      failure.place += fmt::format("{}at load {:.6g}, with {:.3g} of what the new faces held still there",
                                   failure.place.empty() ? "" : ", ", state_.load, 1.0 - gone);
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

// Forces at rounding do work, too, where a body moves without strain: energies below that tell nothing.
void LoadStepper::end_account() {
  constexpr double kRounding = 1e4 * std::numeric_limits<double>::epsilon();
  const auto& u = state_.displacement;
  const double moved = u.head(2 * model_.unknowns.displacements()).cwiseAbs().maxCoeff();
  state_.energies.end_increment(kRounding * model_.stiffness() * moved * moved);
}

Step LoadStepper::commit(const Increment& increment) {
  const double load = increment.load;
  pairs_ = assembler_.pairs();
  if (controls_.control == Control::Path)
    state_.progress = path_progress(model_, state_, increment.displacement, assembler_.plastic());
  Energies& energies = state_.energies;
  energies.elastic = elastic_energy(model_, increment.displacement, assembler_.plastic());
  const auto work = plastic_dissipation(model_, increment.displacement, state_.history);
  energies.plastic_dissipation += work.plastic;
  energies.viscous_dissipation += work.viscous;
  state_.history.plastic = assembler_.plastic();
  energies.contact = 0.0;
  contact::FacePositions faces_before;
  contact::place_faces(model_.surfaces, state_.displacement, faces_before);
  for (std::size_t p = 0; p < pairs_.size(); ++p) {
    const auto index = static_cast<Index>(p);
    const auto& s = pairs_[p].state;
    if (model_.surfaces.is_mortar(model_.surfaces.faces[model_.surfaces.points[p].face].crack)) {
      if (contact::presses(pairs_[p])) state_.history.deepest = std::max(state_.history.deepest, -s.normal_gap);
      state_.history.contact[p] =
          contact::follow(model_.surfaces, assembler_.face_positions(), index, pairs_[p], state_.history.contact[p]);
      continue;
    }
    const auto step =
        contact::advance(model_.surfaces, assembler_.face_positions(), index, pairs_[p], state_.history.contact[p]);
    const auto& law = model_.surfaces.laws[model_.surfaces.faces[model_.surfaces.points[p].face].crack];
    const double weight = model_.surfaces.points[p].weight;
    if (contact::presses(pairs_[p])) {
      energies.contact += 0.5 * weight * s.ramp *
                          (s.traction.normal * s.traction.normal / law.normal_penalty +
                           s.traction.tangential * s.traction.tangential / law.tangential_penalty);
      state_.history.deepest = std::max(state_.history.deepest, -s.normal_gap);
    }
    energies.friction_dissipation += weight * step.friction;
    if (contact::presses(pairs_[p]) && !pairs_[p].anchored)
      energies.friction_dissipation +=
          weight *
          contact::touching_friction(model_.surfaces, faces_before, assembler_.face_positions(), index, pairs_[p]);
    energies.contact_pressure_work += weight * step.pressure;
    state_.history.contact[p] = step.memory;
  }

  if (!model_.surfaces.hats.empty()) {
    auto& hats = state_.history.hats;
    auto step = assembler_.multipliers().advance(model_.surfaces, assembler_.face_positions(), hats);
    energies.contact += step.memory.stored;
    energies.friction_dissipation += step.friction;
    energies.contact_pressure_work += step.pressure;
    hats = std::move(step.memory);
  }

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

  state_.prescribed_force = prescribed;
  state_.previous_load = state_.load;
  state_.previous_displacement = std::move(state_.displacement);
  state_.load = load;
  place_.furthest = std::max(place_.furthest, load);
  state_.displacement = increment.displacement;
  return {.number = ++place_.number, .load = load, .iterations = increment.iterations, .left = increment.left};
}

std::vector<Vec2> LoadStepper::reactions() const {
  std::vector<Vec2> sum(model_.prescribed.size(), Vec2::Zero());
  for (std::size_t k = 0; k < constraints_.size(); ++k)
    sum[constraints_[k].source][constraints_[k].component % 2] += state_.prescribed_force[k];
  return sum;
}

}  // namespace cleft::assembly
