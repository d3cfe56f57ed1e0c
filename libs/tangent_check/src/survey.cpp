#include "cleft/tangent_check/survey.hpp"

#include <algorithm>

#include "taylor_test.hpp"
#include "visited_branches.hpp"

namespace cleft::tangent_check {
namespace {

constexpr int kTries = 3;  // states that are compared for the sake of a branch that cannot be judged in them

// The state swollen by e in all directions: its places times 1 + e. What flows then comes to its apex.
VecX swollen(const assembly::Model& model, const VecX& u, double e) {
  VecX out = u;
  for (Index k = 0; k < model.unknowns.displacements(); ++k) {
    const Index node = model.unknowns.node_of[k];
    const Vec2 reference = node == kNone ? Vec2(Vec2::Zero()) : model.mesh.nodes[node];
    out.segment<2>(2 * k) += e * (reference + u.segment<2>(2 * k));
  }
  return out;
}

class Survey {
 public:
  Survey(const SurveyControls& controls, TangentReport& report, const SurveyObserver& observer)
      : controls_(controls), report_(report), observer_(observer), even_(controls.states) {}

  // False where the survey is over.
  bool visit(const IntermediateState& state) {
    const bool due = even_.takes(state);
    if (!look_at(state, due)) return false;
    if (state.of == IntermediateState::Of::Failure) return true;
    IntermediateState back = state;
    back.displacement = 2.0 * state.before.displacement - state.displacement;
    back.load = state.before.load;
    if (!look_beside_at(back)) return false;
    return !due || look_at_apex(state);
  }

 private:
  bool look_at(const IntermediateState& state, bool due) {
    assembly::Assembler assembler(state.model);
    const CheckedState at{state.model, state.before.history, state.displacement, state.load};
    if (assembler.assemble(at.u, at.history)) return list_without_forces(state);
    const bool new_branch = has_new_branch(at, assembler);  // before the assembler goes elsewhere
    const bool holds = test_remainder(at, controls_.tolerance, assembler, report_.taylor);
    if (due || new_branch || !holds) return compare(state) && holds;
    return true;
  }

  // Of a state that the run does not come to.
  bool look_beside_at(const IntermediateState& state) {
    assembly::Assembler assembler(state.model);
    const CheckedState at{state.model, state.before.history, state.displacement, state.load};
    if (assembler.assemble(at.u, at.history)) return true;
    return !has_new_branch(at, assembler) || compare(state);
  }

  // Swells the state until an apex is met that no state came to.
  bool look_at_apex(const IntermediateState& state) {
    const auto misses_apex = [&] {
      return std::ranges::any_of(report_.not_visited(), [](const auto& name) { return name.ends_with("apex"); });
    };
    for (double e = 1e-4; e < 0.5 && misses_apex(); e *= 2.0) {
      IntermediateState beside = state;
      beside.displacement = swollen(state.model, state.displacement, e);
      if (!look_beside_at(beside)) return false;
    }
    return true;
  }

  bool has_new_branch(const CheckedState& at, const assembly::Assembler& assembler) {
    bool out = false;
    for (const auto& name : branches_at(at, assembler))
      if (!report_.visited(name) && tries_[name]++ < kTries) out = true;
    return out;
  }

  bool compare(const IntermediateState& state) {
    if (check_tangent(state.model, state.before.history, state.displacement, state.load, controls_.tolerance, report_))
      return list_without_forces(state);
    observer_(state, report_);
    return report_.worst() < controls_.tolerance;
  }

  // The run is none the worse for it: it does not come to states between those that converged.
  bool list_without_forces(const IntermediateState& state) {
    report_.kinks.push_back({"this state has no forces", state.load});
    ++report_.taylor.unclear;
    observer_(state, report_);
    return true;
  }

  const SurveyControls& controls_;
  TangentReport& report_;
  const SurveyObserver& observer_;
  EvenlyOverLoad even_;
  std::map<std::string, int> tries_;
};

}  // namespace

std::optional<assembly::Failure> survey(growth::Evolution& body, const SurveyControls& controls, TangentReport& report,
                                        const SurveyObserver& observer) {
  Survey of(controls, report, observer);
  return visit_increments(body, [&](const IntermediateState& state) { return of.visit(state); });
}

}  // namespace cleft::tangent_check
