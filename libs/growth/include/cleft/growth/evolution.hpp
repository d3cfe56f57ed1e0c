/// \file
/// A body taken from load 0 to 1 whose cracks may grow on the way.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <string>

#include "cleft/growth/criterion.hpp"
#include "cleft/solve/stepping.hpp"

namespace cleft::growth {

/// Why a tip grows no more.
enum class Stop : std::uint8_t { None, Boundary, Hindered, MaxAdvances };

/// An advance that is due.
struct PendingAdvance {
  TipName tip;
  Demand demand;
};

/// What growth needs to go on, besides the state: what a checkpoint holds.
struct Record {
  struct Tip {
    int advances = 0;
    Stop stop = Stop::None;
  };
  std::vector<std::vector<Vec2>> points;  ///< of each crack, as grown; metres
  std::vector<double> s_first;            ///< of each crack (geometry::Crack::s_first)
  std::vector<std::array<Tip, 2>> tips;   ///< of each crack
  std::vector<PendingAdvance> pending;    ///< at the present state
  double ratio = 0.0;                     ///< largest demand at the present state
  double beyond = kNever;                 ///< least load known at which a tip would advance,
  double ratio_beyond = 0.0;              ///< and the largest demand there
  static constexpr double kNever = 2.0;   ///< a load that no run reaches
};

/// One tip's part in a step of growth.
struct Advance {
  TipName tip;
  int number = 0;       ///< of this tip's advances, from 1
  Vec2 point;           ///< where the tip is now, metres
  double length = 0.0;  ///< by which the crack got longer, metres; 0 where there was no room
  double angle = 0.0;   ///< of the new piece from the x axis, radians
  double turn = 0.0;    ///< of the new piece against the one before, radians, positive to the left
  Demand demand;
  Stop stop = Stop::None;  ///< why it was the last, if it was
  std::string hindrance;   ///< what the crack would have run into, in words
};

/// A converged increment of the load, or the equilibrium at the same load after cracks have grown.
struct Step : solve::Step {
  std::vector<Advance> advances;  ///< none in an increment
  double released = 0.0;          ///< energy that all of them together set free, J/m
};

/// Takes a body from load 0 to 1. A tip advances when its demand reaches 1: the load of that moment is found within the
/// tolerance of the laws, by shorter and shorter increments around it, so that it hardly depends on the increments.
/// Then all tips that are due advance, the body is cut anew, finds its equilibrium at the same load, and is judged
/// again. Where the law corrects directions, what has grown is taken back and grows anew in the mean of the direction
/// that the criterion asked for before and the one it asks for at the end, unless a tip gets less far or no equilibrium
/// is found that way: a path that bends is followed without zigzag, for one equilibrium more an advance. Without a law
/// this is a LoadStepper and no more.
///
/// An advance ends at the boundary of the body, which is then cut through; in a ball of branch functions so does one
/// that would leave less than half an element ahead. One that would meet a crack, or cut elements
/// that another crack cuts, or wind too tightly for the mesh, is tried at half and a quarter of its length and is the
/// tip's last.
class Evolution {
 public:
  /// `model`: what problem::build_model has made of the specification. Growth needs Control::Load.
  Evolution(problem::Specification specification, assembly::Model model);

  bool done() const { return stepper_->done() && record_.pending.empty(); }

  /// One converged increment or one step of growth, or the failure that ends the run.
  std::variant<Step, assembly::Failure> advance(const solve::IterationObserver& observer = {});

  const solve::LoadStepper& stepper() const { return *stepper_; }
  const assembly::Model& model() const { return *model_; }
  const Record& record() const { return record_; }
  /// Attempts of the last call of `advance` whose iteration failed, in their order.
  const std::vector<solve::FailedAttempt>& failed_attempts() const { return failed_attempts_; }

  /// The state that the last step of growth started from, on the present model; not in balance.
  const assembly::State& origin() const { return origin_; }

  /// Of all models so far.
  assembly::AssemblySeconds assembly_seconds() const;
  solve::SolverSeconds solver_seconds() const;

  /// Goes on from what an earlier run kept.
  void restore(Record record, assembly::State state, solve::StepPlace place, assembly::ReservedCouplings reserved);

 private:
  struct Judged {
    std::vector<PendingAdvance> tips;
    double largest = 0.0;
  };
  /// What the body is like once tips have advanced, in balance.
  struct Attempt {
    std::vector<geometry::Crack> cracks;
    std::vector<Advance> advances;
    std::unique_ptr<const assembly::Model> model;
    std::unique_ptr<solve::LoadStepper> stepper;
    assembly::State origin;
    solve::Step step;
  };
  Judged judge(const assembly::Equilibrium& body) const;
  std::optional<assembly::Failure> no_answer(const Judged& judged) const;
  bool may_grow(const TipName& tip) const;
  double tolerance() const;
  std::variant<Step, assembly::Failure> increase(const solve::IterationObserver& observer);
  std::variant<Step, assembly::Failure> grow(const solve::IterationObserver& observer);
  std::variant<Attempt, assembly::Failure> attempt(const std::vector<PendingAdvance>& due,
                                                   const solve::IterationObserver& observer);
  std::optional<std::vector<PendingAdvance>> corrected(const Attempt& tried) const;
  Vec2 destination(const PendingAdvance& due, const Vec2& from, double length) const;
  Advance lengthen(const PendingAdvance& due, std::vector<geometry::Crack>& cracks) const;
  void count(const solve::LoadStepper& done_with);
  void add_failed_attempts(const solve::LoadStepper& of);
  void replace(std::unique_ptr<const assembly::Model> model, std::unique_ptr<solve::LoadStepper> stepper);

  problem::Specification specification_;
  solve::StepControls controls_;
  std::vector<std::optional<problem::GrowthLaw>> laws_;  // of each crack; none at all where no crack grows
  std::unique_ptr<const assembly::Model> model_;
  std::unique_ptr<solve::LoadStepper> stepper_;
  Record record_;
  assembly::State origin_;
  std::vector<solve::FailedAttempt> failed_attempts_;
  assembly::AssemblySeconds assembly_before_;
  solve::SolverSeconds solver_before_;
};

}  // namespace cleft::growth
