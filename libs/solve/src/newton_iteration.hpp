// Newton's iteration for one increment, step by step.
#pragma once

#include <limits>

#include "active_set.hpp"
#include "active_set_cycling.hpp"
#include "bordered.hpp"
#include "prescription.hpp"
#include "rounding.hpp"

namespace cleft::solve {

/// An iterate's residual and what it is compared with, N/m (2-norms).
struct Balance {
  double residual = 0.0;
  double scale = 0.0;  // of the forces
  double floor = 0.0;  // of rounding
  Resolution resolution;
};

enum class Verdict : std::uint8_t { Continue, Converged, EndedByRounding };

/// Newton's iteration for one increment: the functions in the order in which `run` calls them.
class NewtonIteration {
 public:
  NewtonIteration(const NewtonProblem& problem, const Goal& goal)
      : problem_(problem),
        goal_(goal),
        model_(problem.model),
        state_(problem.state),
        assembler_(problem.assembler),
        cycling_(problem.controls.max_iterations) {}

  Increment run();

 private:
  void begin();
  std::optional<assembly::Failure> evaluate(Iteration& it);
  Balance weigh(Iteration& it);
  Verdict judge(const Iteration& it, const Balance& balance) const;
  Increment finish(const Balance& balance, Verdict verdict);
  bool diverges(const Iteration& it, const Balance& balance);
  std::optional<assembly::Failure> step(Iteration& it);
  VecX prescribe_boundary(Iteration& it);
  Factors factorise(const Iteration& it);
  std::optional<assembly::Failure> solve_linear(const VecX& by_load, Bordered& system, Iteration& it,
                                                Correction& correction);
  void settle_contact(const Bordered& system, Iteration& it, Correction& correction);
  void move(const Correction& correction);
  void record(Iteration& it, const VecX& du);

  bool along_path() const { return goal_.arc_increment > 0.0; }
  bool is_boundary_in_place() const { return change_.size() == 0 || change_.cwiseAbs().maxCoeff() == 0.0; }
  Increment failed(assembly::Failure failure) {
    out_.failure = std::move(failure);
    return std::move(out_);
  }

  const NewtonProblem& problem_;
  const Goal& goal_;
  const assembly::Model& model_;
  const assembly::State& state_;
  assembly::Assembler& assembler_;

  Increment out_;        // load and displacement are those of the iterate
  Prescription wanted_;  // at the iterate's load; the dead loads with what is held
  VecX change_;          // of the prescribed components, still to be made
  VecX rhs_;             // the residual's negative, then the right-hand side
  double reach_ = 0.0;   // metres, that a part may move
  int number_ = 0;       // of corrections so far
  ActiveSet active_;
  ActiveSetCycling cycling_;
  bool returns_ = false;     // to an active set of this increment
  bool parts_held_ = false;  // in some correction
  double first_residual_ = 0.0, last_residual_ = std::numeric_limits<double>::infinity();
  double moved_ = std::numeric_limits<double>::infinity();  // by the last correction, metres
  double correction_ = moved_;                              // the same over what the increment has moved
};

}  // namespace cleft::solve
