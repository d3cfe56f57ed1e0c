/// \file
/// Adaptive load stepping.
#pragma once

#include <cstdint>
#include <limits>

#include "cleft/assembly/equilibrium.hpp"
#include "cleft/assembly/reactions.hpp"
#include "cleft/solve/newton.hpp"
#include "cleft/support/names.hpp"

namespace cleft::solve {

/// What is incremented: the load alone, or the arc length of the path of solutions where the load may fall.
enum class Control : std::uint8_t { Load, Path };
constexpr std::array<Named<Control>, 2> names_of(Control) {
  return {{{Control::Load, "load"}, {Control::Path, "path", "where the load fails to rise, that which turns back"}}};
}

struct StepControls {
  int steps = 50;               ///< equal increments from load 0 to 1
  std::vector<double> outputs;  ///< further loads that are hit exactly, ascending
  /// Error of the work that an increment longer than 1/steps may have, over its share of the largest energy so far.
  /// An increment beyond it is solved again, shorter. The error sets the size of the next one. 0: none is longer.
  double accuracy = 0.0;
  std::vector<double> kinks;  ///< loads at which an amplitude turns; they are hit, ascending
  /// Smallest increment of the load before the run is given up; at most a hundredth of the way to the next load to hit.
  double min_step = 1e-4;
  /// Largest growth of a plastic multiplier in an increment. An increment beyond it is halved, down to a sixteenth of
  /// 1/steps. The return map uses the direction of flow at the end of the increment: long increments flow too easily,
  /// and a run of them finds a limit load that the body does not have.
  double max_flow = std::numeric_limits<double>::infinity();
  Control control = Control::Load;
  NewtonControls newton;
};

/// An attempt at an increment that did not converge.
struct FailedAttempt {
  double load = 0.0;                  ///< at its end, or where its last iterate was on a path
  std::vector<Iteration> iterations;  ///< the last one has no correction if it failed at that residual
};

/// What a converged increment leaves.
struct Step {
  int number = 0;  ///< from 1
  double load = 0.0;
  bool is_output = false;     ///< at one of the outputs, for the first time
  int cuts = 0;               ///< attempts before it that failed, or converged to another branch of solutions
  int iterations_before = 0;  ///< of the parts by which a body was brought into balance, and of attempts given up
  std::vector<Iteration> iterations;
  Iteration left;        ///< residual after the last correction, with no correction of its own
  double rounded = 0.0;  ///< where rounding ended the iteration: what it left, over the largest force so far; else 0
  bool jumped = false;   ///< a fifth or more of the energy that changes its kind is missing: too long, or it has jumped
};

/// Where the load no longer rises nor falls, and nothing but flow or sliding goes on.
struct Plateau {
  double load = 0.0;       ///< at its begin
  double extent = 0.0;     ///< largest displacement of the body at its begin, metres
  double travelled = 0.0;  ///< sum of the largest displacements of the increments since, metres

  /// Takes an increment that has led to the load `now` and moved the body, which has come so far, all in metres by the
  /// largest displacement. The plateau begins anew where the load has changed by 1e-4 of it.
  void follow(double now, double moved, double come);
  /// The body has moved on it as far as it had come at its begin.
  bool goes_on() const;
};

/// Where the stepping stands; with the state and the reserved couplings this is all that a run needs to go on.
struct StepPlace {
  int number = 0;
  double step = 0.0;           ///< increment of the load wanted next, whatever load to hit is nearer
  double arc_increment = 0.0;  ///< increment along the path to try next, over the last one; 0: the load's turn
  double furthest = 0.0;       ///< largest load so far
  double longest = 0.0;        ///< largest displacement of an increment since the path was taken to, metres
  Plateau plateau;             ///< of the path
  int wandered = 0;            ///< increments along the path since the load was largest
};

/// Where an increment should end besides the planned loads.
struct Event {
  double before = 2.0;  ///< a load at which the next increment ends if it would go beyond
  /// Looks at what an increment has converged to before it is kept. Nothing keeps it; with a lower load, above that of
  /// the last converged state, the increment is dropped and one to that load is tried.
  std::function<std::optional<double>(const assembly::Equilibrium&)> judge;
};

/// Takes a model from load 0 to load 1 in increments that are halved where the iteration fails and grow again, up to
/// 1/steps, where it is easy. All outputs and kinks are hit exactly, and the loads k/steps but those within a hundredth
/// of 1/steps of an output or kink. An increment that is short because it ends at one of them, or at an event, leaves
/// the size that is wanted as it is. With an accuracy increments are as long as that allows, where the iteration is
/// easy, and only outputs and kinks are hit. The first after a kink is no longer than 1/steps and not extrapolated.
///
/// With Control::Path an increment of the load that fails is tried along the path instead, and so are those after it,
/// until the load rises by half a step at once: the path may pass limit points and turn back. The outputs, the kinks
/// and load 1 are still hit exactly, each where the load first comes to it; at a kink the load takes its turn again. An
/// increment that has jumped to another branch of solutions, as the energies tell, is dropped: on the path for a
/// shorter one, down to 1/64 of the longest; of the load for the path and, where that leads nowhere, made after all.
/// Increments that fail become as short as 1/4096 of the longest; then the load leads once, the way that it went. The
/// run ends on a plateau, where the body could only unload elastically, where the path leads back to load 0 or to
/// where a load turned, and where it has come to no higher load in 20 times `steps` increments (at least 1000).
class LoadStepper {
 public:
  /// `model` must outlive the stepper.
  LoadStepper(const assembly::Model& model, StepControls controls);

  bool done() const { return state_.load >= 1.0; }

  /// One converged increment, or the failure that ends the run (the state then stays at what converged last).
  std::variant<Step, assembly::Failure> advance(const IterationObserver& observer = {}, const Event& event = {});

  /// Equilibrium at the present load, for a state that is not in balance because new faces have been cut through it.
  /// What these transmit is taken away at once or, where that fails, bit by bit; the energy set free is counted in
  /// Energies::released. After a failure the state is somewhere on the way.
  std::variant<Step, assembly::Failure> equilibrate(const IterationObserver& observer = {});

  const assembly::Model& model() const { return model_; }
  const assembly::State& state() const { return state_; }
  assembly::Equilibrium equilibrium() const {
    return {model_, state_.load, state_.displacement, state_.history.plastic, pairs_};
  }
  const std::vector<assembly::Constraint>& constraints() const { return constraints_; }
  /// Pairs of the last converged increment, with tractions and gaps; the history in `state()` is already that of the
  /// next.
  const std::vector<contact::Pair>& pairs() const { return pairs_; }
  const contact::FacePositions& face_positions() const { return assembler_.face_positions(); }
  const assembly::Assembler& assembler() const { return assembler_; }
  const LinearSolver& solver() const { return solver_; }
  /// Attempts of the last call of `advance` or `equilibrate` whose iteration failed, in their order.
  const std::vector<FailedAttempt>& failed_attempts() const { return failed_attempts_; }
  StepPlace place() const { return place_; }

  /// Goes on from what an earlier run kept; without reserved couplings, with those at rest.
  void restore(assembly::State state, StepPlace place, std::optional<assembly::ReservedCouplings> reserved = {});

  /// Force on the body (N/m) through each prescribed boundary of the model, in its order; what holds a node that
  /// several prescribe is divided among them (reactions.hpp).
  std::vector<Vec2> reactions() const;

  /// Whether symmetric factorisation is allowed: no contact, and no plastic flow that is not associated.
  static Factorisation factorisation_for(const assembly::Model& model);

 private:
  enum class Effort : std::uint8_t { Little, Much };        // that an increment took: after little the next may grow
  enum class Guide : std::uint8_t { LastIncrement, None };  // to how the next one will go: nothing is at a kink
  struct Committed {
    assembly::State state;
    StepPlace place;
    std::vector<contact::Pair> pairs;
  };
  struct Attempt {
    bool along_path = false;
    double taken = 0.0;  // of the load, if it is not along the path
    double size = 0.0;   // the same, or the arc increment
    double flow = 0.0;   // the largest in a cell; 0 along the path
    Increment increment{};
  };
  // The attempts at one increment so far.
  struct Tries {
    Guide guide = Guide::None;
    double least = 0.0;                // increment of the load
    double before = 2.0;               // a load at which the increment ends if it would go beyond
    int cuts = 0, iterations = 0;      // in vain
    std::optional<StepPlace> dropped;  // where an increment of the load seemed to jump
    bool believes = false;             // keeps it after all
    bool led = false;                  // by the load, past a kink of the path
  };

  double planned() const { return 1.0 / controls_.steps; }
  static bool is_easy(const Increment& increment);
  double next_end(double before) const;
  double lowest() const;
  double next_mark() const;
  Increment solve(const Goal& goal, const IterationObserver& observer);
  Increment try_path(const IterationObserver& observer);
  bool knows_path() const;
  bool is_longer(double part) const;
  bool shorten(double taken, double least);
  double fitting(double missed) const;
  void lengthen(Effort effort, double fits);
  double cut_short(const Increment& increment) const;
  double missed_work(const assembly::State& before, Guide guide) const;
  assembly::Failure given_up(assembly::Failure failure, double load, double size) const;
  Step commit(const Increment& increment);
  std::optional<Step> commit_if_accurate(const Increment& increment, Effort effort, Guide guide);
  Step commit_on_path(const Increment& increment, Effort effort);
  bool is_guarded() const;
  std::optional<assembly::Failure> refuse(const Increment& increment) const;
  std::optional<assembly::Failure> end_of_path() const;
  assembly::Failure led_back() const;
  void go_back_to(const Committed& before);
  Tries first_try(const Event& event);
  bool try_again(double taken, Tries& tries);
  Attempt attempt(const Tries& tries, const IterationObserver& observer);
  bool is_too_long(const Attempt& tried, const Event& event, Tries& tries);
  void lead_by_load(Increment& increment, Tries& tries, const IterationObserver& observer);
  Effort effort_of(const Increment& increment, double flow, const Tries& tries) const;
  std::optional<Step> keep(const Increment& increment, double flow, Tries& tries);
  void end_account();

  const assembly::Model& model_;
  StepControls controls_;
  std::vector<assembly::Constraint> constraints_;
  assembly::Reactions reactions_;
  std::vector<double> marks_, targets_;
  std::vector<double> path_ends_;  // kinks below which no path leads on
  assembly::Assembler assembler_;
  LinearSolver solver_;
  assembly::State state_;
  StepPlace place_;
  std::vector<contact::Pair> pairs_;
  std::vector<FailedAttempt> failed_attempts_;
};

}  // namespace cleft::solve
