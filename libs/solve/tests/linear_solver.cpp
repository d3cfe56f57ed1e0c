// Matrices that are wrong, and what the solver keeps between them.
#include "cleft/solve/linear_solver.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "nested_dissection.hpp"
#include "umfpack.hpp"

namespace cleft::solve {
namespace {

// Springs from block to block along a chain, the first one to the ground unless it floats.
assembly::BlockMatrix chain(Index size, bool floats) {
  std::vector<std::array<Index, 2>> blocks;
  for (Index i = 0; i + 1 < size; ++i) {
    blocks.push_back({i, i + 1});
    blocks.push_back({i + 1, i});
  }
  assembly::BlockMatrix m(size, blocks);
  for (Index i = 0; i + 1 < size; ++i) {
    const Mat2 k = Mat2::Identity();
    m.add(m.find(i, i), k);
    m.add(m.find(i + 1, i + 1), k);
    m.add(m.find(i, i + 1), -k);
    m.add(m.find(i + 1, i), -k);
  }
  if (!floats) m.add(m.find(0, 0), Mat2::Identity());
  return m;
}

class Solver : public testing::TestWithParam<Factorisation> {};
INSTANTIATE_TEST_SUITE_P(Kinds, Solver, testing::Values(Factorisation::Unsymmetric, Factorisation::Symmetric));

TEST_P(Solver, ReportsAFloatingChain) {
  LinearSolver solver(GetParam());
  solver.new_pattern(1);
  EXPECT_NE(solver.factorise(chain(6, true)), Factors::Regular);
}

TEST_P(Solver, ReportsAChainThatFloatsButForRounding) {
  for (const double spring : {1e-14, -1e-14}) {
    assembly::BlockMatrix m = chain(6, true);
    m.add(m.find(0, 0), spring * Mat2::Identity());
    LinearSolver solver(GetParam());
    solver.new_pattern(1);
    EXPECT_EQ(solver.factorise(m), Factors::Doubtful);
    EXPECT_EQ(solver.seconds().second_opinions, 1);
  }
}

TEST_P(Solver, ReportsValuesThatAreNotNumbers) {
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    for (const Index at : {0, 3, 5}) {
      assembly::BlockMatrix m = chain(6, false);
      m.add(m.find(at, at), bad * Mat2::Ones());
      LinearSolver solver(GetParam());
      solver.new_pattern(1);
      EXPECT_EQ(solver.factorise(m), Factors::None) << bad << " in block " << at;
    }
}

TEST_P(Solver, RecoversAfterAMatrixThatFailed) {
  LinearSolver solver(GetParam());
  solver.new_pattern(1);
  EXPECT_NE(solver.factorise(chain(6, true)), Factors::Regular);
  const assembly::BlockMatrix good = chain(6, false);
  ASSERT_EQ(solver.factorise(good), Factors::Regular);
  const VecX b = VecX::LinSpaced(12, 1.0, 2.0);
  EXPECT_LT((good.multiply(solver.solve(b)) - b).norm(), 1e-12);
}

TEST(Umfpack, SolvesWithoutTheMatrixThatItFactorised) {
  SolverSeconds seconds;
  Umfpack solver(seconds);
  VecX b, x;
  const assembly::BlockMatrix m = chain(9, false);
  {
    const assembly::BlockMatrix gone = m;
    ASSERT_EQ(solver.factorise(gone), Factors::Regular);
  }
  b = VecX::LinSpaced(m.rows(), 1.0, 2.0);
  x = solver.solve(b);
  EXPECT_LT((m.multiply(x) - b).norm(), 1e-12);
}

TEST_P(Solver, SolvesSystemsLargeEnoughForNestedDissection) {
  const assembly::BlockMatrix m = chain(50'001, false);
  LinearSolver solver(GetParam());
  solver.new_pattern(1);
  ASSERT_EQ(solver.factorise(m), Factors::Regular);
  EXPECT_EQ(solver.seconds().second_opinions, 0);
  const VecX b = VecX::LinSpaced(m.rows(), 1.0, 2.0);
  EXPECT_LT((m.multiply(solver.solve(b)) - b).norm(), 1e-6 * b.norm());
}

// A multiplier's row has no diagonal entry: pivots are found off it.
TEST(Unsymmetric, SolvesWithEmptyDiagonals) {
  assembly::BlockMatrix m(2, {{0, 1}, {1, 0}});
  m.add(m.find(0, 0), 2.0 * Mat2::Identity());
  m.add(m.find(0, 1), Mat2::Identity());
  m.add(m.find(1, 0), 3.0 * Mat2::Identity());
  LinearSolver solver(Factorisation::Unsymmetric);
  solver.new_pattern(1);
  ASSERT_EQ(solver.factorise(m), Factors::Regular);
  EXPECT_EQ(solver.seconds().second_opinions, 0);
  const VecX b = VecX::LinSpaced(4, 1.0, 2.0);
  EXPECT_LT((m.multiply(solver.solve(b)) - b).norm(), 1e-14);
}

TEST(NestedDissection, IsAPermutationThatKeepsBlocksTogether) {
  const Index size = 300;
  const auto position = nested_dissection(chain(size, false));
  ASSERT_EQ(position.size(), 600u);
  std::vector<bool> taken(position.size(), false);
  for (std::size_t k = 0; k < position.size(); k += 2) {
    EXPECT_EQ(position[k] % 2, 0);
    EXPECT_EQ(position[k + 1], position[k] + 1);
    EXPECT_FALSE(taken[position[k]]);
    taken[position[k]] = true;
  }
}

TEST_P(Solver, AnalysesOncePerPattern) {
  LinearSolver solver(GetParam());
  for (const Index size : {5, 8}) {
    solver.new_pattern(size);
    for (int k = 0; k < 3; ++k) {
      const assembly::BlockMatrix m = chain(size, false);
      ASSERT_EQ(solver.factorise(m), Factors::Regular);
      const VecX b = VecX::Ones(2 * size);
      EXPECT_LT((m.multiply(solver.solve(b)) - b).norm(), 1e-12);
    }
  }
  EXPECT_EQ(solver.seconds().analyses, 2);
  EXPECT_EQ(solver.seconds().factorisations, 6);
  EXPECT_EQ(solver.seconds().second_opinions, 0);
}

}  // namespace
}  // namespace cleft::solve
