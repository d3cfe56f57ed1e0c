#include <Eigen/Sparse>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>

#include "cleft/assembly/stress.hpp"
#include "cleft/problem/build.hpp"
#include "cleft/simulation/failure_words.hpp"
#include "hard_sweeps.hpp"

namespace cleft::verification {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

// The rows and columns of the components that are not prescribed, each divided by the root of its diagonal entry.
Sparse scaled_tangent(const assembly::Model& model, const assembly::BlockMatrix& matrix) {
  const Eigen::Map<const Sparse> whole(matrix.rows(), matrix.rows(), matrix.nonzeros(), matrix.scalar_starts().data(),
                                       matrix.scalar_rows().data(), matrix.values().data());
  std::vector<Index> number(static_cast<std::size_t>(matrix.rows()), 0);
  for (const auto& constraint : assembly::constraints_of(model)) number[constraint.component] = kNone;
  Index count = 0;
  for (Index& n : number)
    if (n != kNone) n = count++;
  std::vector<Eigen::Triplet<double>> entries;
  for (Index c = 0; c < matrix.rows(); ++c)
    for (Eigen::Map<const Sparse>::InnerIterator it(whole, c); it; ++it)
      if (number[c] != kNone && number[it.row()] != kNone)
        entries.emplace_back(number[it.row()], number[c],
                             it.value() / std::sqrt(whole.coeff(c, c) * whole.coeff(it.row(), it.row())));
  Sparse out(count, count);
  out.setFromTriplets(entries.begin(), entries.end());
  return out;
}

double condition_of(const Sparse& K) {
  const Eigen::SimplicialLDLT<Sparse> inverse(K);
  VecX high(K.rows()), low(K.rows());
  for (Eigen::Index k = 0; k < K.rows(); ++k) high[k] = low[k] = std::sin(1.0 + static_cast<double>(k * k % 1009));
  double largest = 0.0, smallest = 0.0;
  for (int k = 0; k < 100; ++k) {
    high = K * high.normalized();
    low = inverse.solve(low.normalized());
    largest = high.norm();
    smallest = 1.0 / low.norm();
  }
  return largest / smallest;
}

double stress_of_cell(const assembly::Model& model, const VecX& displacement, Index cell) {
  return assembly::stress_of(model.material(cell), assembly::deformation(model, cell, displacement)).in_plane.norm();
}

bool at_tip(const assembly::Model& model, const enrichment::Cell& cell) {
  return std::any_of(cell.unknown.begin(), cell.unknown.end(), [&](Index unknown) {
    return std::binary_search(model.cut.tip_nodes.begin(), model.cut.tip_nodes.end(), model.unknowns.node_of[unknown]);
  });
}

void look_at_slivers(const assembly::Model& model, const VecX& displacement, Swept& out) {
  Index sliver = kNone;
  for (Index c = 0; c < static_cast<Index>(model.cells.size()); ++c) {
    const auto& cell = model.cells[c];
    const double part = cell.area / geometry::triangle_area(model.mesh, cell.element);
    if (cell.cut == kNone || part >= out.smallest || at_tip(model, cell)) continue;
    out.smallest = part;
    sliver = c;
  }
  if (sliver == kNone) return;
  double beside = 0.0;
  for (Index c = 0; c < static_cast<Index>(model.cells.size()); ++c) {
    if (c == sliver) continue;
    int shared = 0;
    for (const Index u : model.cells[c].unknown)
      for (const Index v : model.cells[sliver].unknown) shared += u == v;
    if (shared == 2) beside = std::max(beside, stress_of_cell(model, displacement, c));
  }
  if (beside > 0.0) out.sliver_stress = stress_of_cell(model, displacement, sliver) / beside;
}

}  // namespace

Swept sweep(const problem::Specification& scene) {
  Swept out;
  const assembly::Model model = problem::build_model(scene);
  solve::LoadStepper stepper(model, problem::step_controls(scene));
  {
    problem::Specification with_springs = scene;  // which can be taken away again
    for (auto& crack : with_springs.cracks) crack.mortar.on = false;
    assembly::Model open = problem::build_model(with_springs);
    open.surfaces.points.clear();
    assembly::Assembler assembler(open);
    const auto rest = assembly::state_at_rest(open);
    if (auto failure = assembler.assemble(rest.displacement, rest.history)) {
      out.failure = simulation::describe(*failure, open);
      return out;
    }
    out.condition = condition_of(scaled_tangent(open, assembler.matrix()));
  }
  constexpr double kLoose = 1e12;
  out.loose = !(out.condition < kLoose);
  if (out.loose) return out;
  while (!stepper.done()) {
    const auto outcome = stepper.advance();
    if (const auto* failure = std::get_if<assembly::Failure>(&outcome)) {
      out.failure = simulation::describe(*failure, model);
      return out;
    }
    const auto& step = std::get<solve::Step>(outcome);
    out.cuts += step.cuts;
    out.iterations.push_back(static_cast<int>(step.iterations.size()));
  }
  out.reaction = stepper.reactions().back();
  const auto& state = stepper.state();
  if (!state.displacement.allFinite() || !out.reaction.allFinite() || !std::isfinite(state.energies.imbalance()))
    out.failure = "not finite";
  look_at_slivers(model, state.displacement, out);
  return out;
}

}  // namespace cleft::verification
