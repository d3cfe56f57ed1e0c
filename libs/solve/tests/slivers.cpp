// A crack that comes as near to nodes as it likes: what is left of a triangle beyond it must neither fold nor spoil the
// tangent, and the answer must not jump.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "cleft/solve/stepping.hpp"
#include "small_models.hpp"

namespace cleft::solve {
namespace {

// The block of Liu and Borja (2010), section 6.1, with its crack moved so that it passes a line of nodes at a distance
// of `offset` cells; 8 x 16 cells, whose diagonals it runs along.
assembly::Model block_past_nodes(double offset) {
  constexpr double kCell = 0.005;
  assembly::Model m;
  m.mesh = geometry::structured_mesh({0, 0, 0.04, 0.08}, {8, 16}, geometry::Diagonal::Left);
  const double rise = 4.0 * kCell + std::sqrt(2.0) * offset * kCell;
  m.cracks = {{"main", {{0.0, rise}, {0.0349, rise + 0.0349}}}};
  models::discretise(m, 1.0, 0.3, contact::NegativeSide::Left, 1e10);
  m.prescribed = {models::hold(m, "bottom", {0, 0}), models::hold(m, "top", {-0.008, -0.008})};
  return m;
}

struct Outcome {
  long iterations = 0;
  int cuts = 0;
  Vec2 reaction;
};

Outcome solve(const assembly::Model& m) {
  StepControls controls;
  controls.steps = 16;
  LoadStepper stepper(m, controls);
  Outcome out;
  while (!stepper.done()) {
    const auto outcome = stepper.advance();
    if (!std::holds_alternative<Step>(outcome)) {
      ADD_FAILURE() << name_of(std::get<assembly::Failure>(outcome).kind);
      return out;
    }
    out.iterations += static_cast<long>(std::get<Step>(outcome).iterations.size());
    out.cuts += std::get<Step>(outcome).cuts;
  }
  out.reaction = stepper.reactions()[1];
  return out;
}

TEST(Slivers, CostNoIncrementHoweverThinTheyAre) {
  const Outcome far = solve(block_past_nodes(1e-1));
  for (const double side : {-1.0, 1.0}) {
    std::optional<Vec2> reaction;
    for (const double offset : {3e-2, 1e-2, 3e-3, 1e-3, 1e-4, 1e-5}) {
      SCOPED_TRACE(side * offset);
      const Outcome near = solve(block_past_nodes(side * offset));
      EXPECT_EQ(near.cuts, 0);
      EXPECT_LE(near.iterations, far.iterations + 2);
      // the crack itself moves, and its end from one element edge to another
      if (reaction) {
        EXPECT_LT((near.reaction - *reaction).norm(), 0.07 * reaction->norm());
      }
      reaction = near.reaction;
    }
  }
}

TEST(Slivers, TiesStoreEnergyThatTheForcesGiveBack) {
  const assembly::Model m = block_past_nodes(1e-2);
  ASSERT_FALSE(m.ties.empty());
  const assembly::State rest = state_at_rest(m);
  VecX u(m.unknowns.components()), direction(u.size());
  for (Eigen::Index k = 0; k < u.size(); ++k) {
    u[k] = 1e-5 * std::sin(1.0 + 7.0 * static_cast<double>(k));
    direction[k] = std::cos(3.0 * static_cast<double>(k));
  }
  assembly::Model without = m;
  without.ties.clear();
  const auto energy = [&](const assembly::Model& of, double along) {
    return elastic_energy(of, u + along * direction, rest.history.plastic);
  };
  EXPECT_GT(energy(m, 0.0), 1.001 * energy(without, 0.0)) << "they do nothing";
  constexpr double kStep = 1e-9;
  const double slope = (energy(m, kStep) - energy(m, -kStep)) / (2.0 * kStep);
  assembly::Assembler assembler(m);
  ASSERT_FALSE(assembler.assemble(u, rest.history));
  const VecX bulk = assembler.internal_force() - assembler.contact_force();
  EXPECT_NEAR(bulk.dot(direction), slope, 1e-6 * bulk.norm());
}

}  // namespace
}  // namespace cleft::solve
