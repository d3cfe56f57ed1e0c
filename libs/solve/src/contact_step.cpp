#include "contact_step.hpp"

#include "cleft/contact/complementarity.hpp"

namespace cleft::solve {
namespace {

using contact::ContactProblem, contact::NodeChoice;

// Components of the nodes: the dense problem takes a second or so. Larger ones are left to the iteration.
constexpr Index kMost = 1000;

// Hats with something opposite.
std::vector<Index> supported(const assembly::Assembler& assembler) {
  std::vector<Index> out;
  const auto& nodes = assembler.multipliers().nodes();
  for (Index i = 0; i < static_cast<Index>(nodes.size()); ++i)
    if (nodes[i].supported) out.push_back(i);
  return out;
}

class Condensed {
 public:
  Condensed(const assembly::Model& model, const assembly::History& history, const VecX& u, const VecX& du,
            assembly::Assembler& assembler)
      : model_(model), assembler_(assembler), nodes_(supported(assembler)) {
    const auto n = static_cast<Eigen::Index>(nodes_.size());
    problem_.force = tractions(u + du);
    problem_.by_force.resize(2 * n, 2 * n);
    problem_.by_level.resize(2 * n, 2 * n);
    for (const Index i : nodes_) {
      const auto& state = assembler.multipliers().nodes()[i];
      choice_.push_back({state.status, state.slides});
      problem_.laws.push_back(law_of(i, state, history));
    }
  }

  const std::vector<Index>& nodes() const { return nodes_; }
  Index row(Index k) const { return 2 * model_.surfaces.first_multiplier + 2 * nodes_[k / 2] + k % 2; }

  void set_levels(const VecX& du) {
    problem_.level = rows_of(assembler_.internal_force() + assembler_.matrix().multiply(du));
  }
  void add_response(Index k, const VecX& response) {
    problem_.by_force.col(k) = tractions(response);
    problem_.by_level.col(k) = rows_of(assembler_.matrix().multiply(response));
  }
  std::optional<VecX> solve() { return contact::solve(problem_, choice_); }

 private:
  // The tangent of the law at the node's pressure.
  contact::NodeLaw law_of(Index i, const contact::NodeState& state, const assembly::History& history) const {
    const auto& s = model_.surfaces;
    const auto& node = s.multiplier_space.nodes[i];
    const auto strength = contact::strength(s.laws[node.crack], -state.normal, history.multipliers.state[i]);
    return {strength.by_pressure, s.mortar[node.crack].scale * s.touch().length * node.length,
            history.multipliers.status[i] != contact::Status::Open,
            node.length * (strength.value + strength.by_pressure * state.normal)};
  }
  // L l of the nodes, N/m.
  VecX tractions(const VecX& x) const {
    VecX out(2 * nodes_.size());
    for (Index k = 0; k < out.size(); ++k) {
      const auto& node = model_.surfaces.multiplier_space.nodes[nodes_[k / 2]];
      out[k] = node.length * model_.surfaces.mortar[node.crack].scale * x[row(k)];
    }
    return out;
  }
  VecX rows_of(const VecX& x) const {
    VecX out(2 * nodes_.size());
    for (Index k = 0; k < out.size(); ++k) out[k] = x[row(k)];
    return out;
  }

  const assembly::Model& model_;
  const assembly::Assembler& assembler_;
  std::vector<Index> nodes_;
  std::vector<NodeChoice> choice_;
  ContactProblem problem_;
};

}  // namespace

std::optional<Correction> contact_step(const assembly::Model& model, const assembly::History& history, const VecX& u,
                                       const VecX& du, assembly::Assembler& assembler, const Bordered& system) {
  Condensed condensed(model, history, u, du, assembler);
  const auto count = static_cast<Index>(2 * condensed.nodes().size());
  if (count == 0 || count > kMost || assembler.assemble(u, history, contact::Conditions::Stick)) return std::nullopt;
  condensed.set_levels(du);
  VecX on_rows = VecX::Zero(u.size());
  for (Index k = 0; k < count; ++k) {
    on_rows[condensed.row(k)] = 1.0;
    condensed.add_response(k, system.solve(on_rows).displacement);
    on_rows[condensed.row(k)] = 0.0;
  }
  const auto changes = condensed.solve();
  if (!changes) return std::nullopt;
  for (Index k = 0; k < count; ++k) on_rows[condensed.row(k)] = (*changes)[k];
  return system.solve(on_rows);
}

}  // namespace cleft::solve
