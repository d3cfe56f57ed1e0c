#include "cleft/assembly/stepping.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cleft/contact/history.hpp"

namespace cleft::assembly {
namespace {

constexpr double kSameLoad = 1e-12;
constexpr double kCrumb = 1e-2;             // of the planned increment: however short that is, it may be cut to this
constexpr std::size_t kEasyIterations = 5;  // an increment that took no more lets the next one grow

std::vector<double> targets_of(const StepControls& controls) {
  std::vector<double> all(controls.outputs);
  for (int k = 1; k <= controls.steps; ++k) all.push_back(static_cast<double>(k) / controls.steps);
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end(), [](double a, double b) { return b - a < kSameLoad; }), all.end());
  all.back() = 1.0;
  return all;
}

}  // namespace

Factorisation LoadStepper::factorisation_for(const Model& model) {
  return model.has_contact() || !is_symmetric(model.material) ? Factorisation::Unsymmetric : Factorisation::Symmetric;
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

void LoadStepper::restore(State state, StepPlace place, ContactRoom room) {
  state_ = std::move(state);
  place_ = place;
  assembler_.set_room(std::move(room));
}

double LoadStepper::next_target() const {
  const auto at = std::upper_bound(targets_.begin(), targets_.end(), state_.load + kSameLoad);
  return at == targets_.end() ? 1.0 : *at;
}

std::variant<Step, Failure> LoadStepper::advance(const IterationObserver& observer) {
  Step out;
  for (;;) {
    const double target = next_target();
    const double rest = target - state_.load;
    // no crumbs: what is left after this increment is either nothing or at least as large
    const double size = rest <= place_.step * (1.0 + 1e-9) ? rest : std::min(place_.step, 0.5 * rest);
    const double load = size == rest ? target : state_.load + size;
    const Increment increment =
        solve_increment(model_, constraints_, state_, load, controls_.newton, assembler_, solver_, observer);
    if (increment.failure) {
      ++out.cuts;
      place_.step = 0.5 * size;
      if (place_.step < controls_.min_step) {
        Failure failure = *increment.failure;
        failure.place = fmt::format("{}at load {:.6g} (last converged: {:.6g}), increments down to {:.1e}",
                                    failure.place.empty() ? "" : failure.place + ", ", load, state_.load, size);
        return failure;
      }
      continue;
    }
    commit(load, increment);
    if (increment.iterations.size() <= kEasyIterations && out.cuts == 0)
      place_.step = std::min(2.0 * place_.step, 1.0 / controls_.steps);
    out.number = ++place_.number;
    out.load = load;
    out.iterations = increment.iterations;
    out.left = increment.left;
    return out;
  }
}

void LoadStepper::commit(double load, const Increment& increment) {
  pairs_ = assembler_.pairs();
  Energies& energies = state_.energies;
  energies.elastic = elastic_energy(model_, increment.displacement, assembler_.plastic());
  energies.plastic_dissipation += plastic_dissipation(model_, increment.displacement, state_.history);
  state_.history.plastic = assembler_.plastic();
  energies.contact = 0.0;
  for (std::size_t p = 0; p < pairs_.size(); ++p) {
    const auto index = static_cast<Index>(p);
    const auto& s = pairs_[p].state;
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
    energies.friction_dissipation += weight * step.dissipation;
    state_.history.contact[p] = step.memory;
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
  state_.displacement = increment.displacement;
}

std::vector<Vec2> LoadStepper::reactions() const {
  std::vector<Vec2> sum(model_.prescribed.size(), Vec2::Zero());
  for (std::size_t k = 0; k < constraints_.size(); ++k)
    sum[constraints_[k].source][constraints_[k].component % 2] += state_.prescribed_force[k];
  return sum;
}

}  // namespace cleft::assembly
