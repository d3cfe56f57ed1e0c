#include <gtest/gtest.h>

#include <Eigen/LU>
#include <random>

#include "cleft/solve/linear_solver.hpp"
#include "cleft/solve/stepping.hpp"
#include "small_models.hpp"

namespace cleft::solve {
namespace {

// A chain of blocks with neighbours coupled, filled at random; symmetric if asked for.
assembly::BlockMatrix random_matrix(Index size, bool symmetric, double diagonal, Eigen::MatrixXd& dense) {
  std::vector<std::array<Index, 2>> blocks;
  for (Index i = 0; i + 1 < size; ++i)
    for (const auto& [r, c] : {std::array{i, i + 1}, {i + 1, i}, {i, i + 1}}) blocks.push_back({r, c});
  blocks.push_back({0, size - 1});
  blocks.push_back({size - 1, 0});
  assembly::BlockMatrix m(size, blocks);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  dense = Eigen::MatrixXd::Zero(2 * size, 2 * size);
  for (Index c = 0; c < size; ++c)
    for (const Index r : m.block_rows(c)) {
      if (symmetric && r > c) continue;
      Mat2 block;
      block << number(random), number(random), number(random), number(random);
      if (symmetric && r == c) block = Mat2(block + block.transpose());
      if (r == c) block += diagonal * Mat2::Identity();
      m.add(m.find(r, c), block);
      dense.block<2, 2>(2 * r, 2 * c) += block;
      if (symmetric && r < c) {
        m.add(m.find(c, r), block.transpose());
        dense.block<2, 2>(2 * c, 2 * r) += block.transpose();
      }
    }
  return m;
}

TEST(BlockMatrix, MergesRepeatedBlocksAndKnowsWhatIsAbsent) {
  Eigen::MatrixXd dense;
  const assembly::BlockMatrix m = random_matrix(6, false, 4.0, dense);
  EXPECT_EQ(m.nonzeros(), 4 * (6 + 2 * 5 + 2));
  EXPECT_EQ(m.find(0, 3).start, kNone);
  EXPECT_NE(m.find(0, 5).start, kNone);
}

TEST(BlockMatrix, MultipliesLikeTheDenseMatrix) {
  Eigen::MatrixXd dense;
  const assembly::BlockMatrix m = random_matrix(7, false, 4.0, dense);
  const VecX x = VecX::Random(14);
  EXPECT_LT((m.multiply(x) - dense * x).norm(), 1e-14);
}

TEST(LinearSolver, SolvesUnsymmetricAndSymmetricSystems) {
  for (const bool symmetric : {false, true}) {
    Eigen::MatrixXd dense;
    const assembly::BlockMatrix m = random_matrix(9, symmetric, 6.0, dense);
    LinearSolver solver(symmetric ? Factorisation::Symmetric : Factorisation::Unsymmetric);
    solver.new_pattern(1);
    ASSERT_EQ(solver.factorise(m), Factors::Regular);
    const VecX b = VecX::Random(18);
    EXPECT_LT((solver.solve(b) - dense.lu().solve(b)).norm(), 1e-12);
    EXPECT_EQ(solver.seconds().second_opinions, 0);
  }
}

TEST(LinearSolver, AnIndefiniteSymmetricMatrixIsStillSolved) {
  Eigen::MatrixXd dense;
  const assembly::BlockMatrix m = random_matrix(9, true, 0.0, dense);
  LinearSolver solver(Factorisation::Symmetric);
  solver.new_pattern(1);
  ASSERT_EQ(solver.factorise(m), Factors::Regular);
  const VecX b = VecX::Random(18);
  EXPECT_LT((solver.solve(b) - dense.lu().solve(b)).norm(), 1e-9);
  EXPECT_EQ(solver.seconds().second_opinions, 0);
}

// Two negative eigenvalues or one, by MUMPS' factors of either kind and, where a pivot is tiny, by those of UMFPACK.
TEST(LinearSolver, TellsTheSignOfTheDeterminantAndTheLeastPivot) {
  for (const bool symmetric : {false, true})
    for (const double least : {1e-3, 1e-13})
      for (const bool negative : {false, true}) {
        assembly::BlockMatrix m(2, {{0, 0}, {1, 1}});
        m.add(m.find(0, 0), (Mat2() << -1.0, 0.0, 0.0, -1.0).finished());
        m.add(m.find(1, 1), (Mat2() << 1.0, 1.0, 1.0, negative ? 1.0 - least : 1.0 + least).finished());
        LinearSolver solver(symmetric ? Factorisation::Symmetric : Factorisation::Unsymmetric);
        solver.new_pattern(1);
        ASSERT_NE(solver.factorise(m), Factors::None);
        EXPECT_EQ(solver.seconds().second_opinions, least < 1e-12 ? 1 : 0);
        EXPECT_EQ(solver.pivots().negative_determinant, negative);
        EXPECT_NEAR(std::log2(solver.pivots().least / least), 0.0, 1.1) << "UMFPACK has scaled the rows";
      }
}

TEST(LinearSolver, ASingularMatrixIsReported) {
  const assembly::BlockMatrix zero(3, {});
  for (const auto kind : {Factorisation::Unsymmetric, Factorisation::Symmetric}) {
    LinearSolver solver(kind);
    solver.new_pattern(1);
    EXPECT_EQ(solver.factorise(zero), Factors::None);
  }
}

assembly::Model square(double top) {
  assembly::Model m;
  m.mesh = geometry::structured_mesh({0, 0, 1, 1}, {4, 4}, geometry::Diagonal::Alternating);
  models::discretise(m, 1.0, 0.0, contact::NegativeSide::Right, 1e6);
  m.prescribed = {models::hold(m, "bottom", {0, 0}), models::hold(m, "top", {0, top})};
  return m;
}

TEST(LoadStepper, AnUnloadedBodyConvergesAtOnce) {
  const assembly::Model m = square(0.0);
  LoadStepper stepper(m, models::in_steps(1));
  const auto outcome = stepper.advance();
  ASSERT_TRUE(std::holds_alternative<Step>(outcome));
  EXPECT_TRUE(std::get<Step>(outcome).iterations.empty());
}

TEST(LoadStepper, AnIncrementThatIsFarTooLargeIsCut) {
  const assembly::Model m = square(-0.75);
  StepControls controls = models::in_steps(1);
  controls.newton.max_iterations = 4;
  LoadStepper stepper(m, controls);
  int cuts = 0;
  while (!stepper.done()) {
    const auto outcome = stepper.advance();
    ASSERT_TRUE(std::holds_alternative<Step>(outcome)) << name_of(std::get<assembly::Failure>(outcome).kind);
    cuts += std::get<Step>(outcome).cuts;
  }
  EXPECT_GT(cuts, 0);
}

TEST(LoadStepper, FailuresNameTheElementThatInverts) {
  const assembly::Model m = square(-1.5);  // the top passes through the bottom
  StepControls controls = models::in_steps(4);
  controls.min_step = 0.05;
  LoadStepper stepper(m, controls);
  std::variant<Step, assembly::Failure> outcome;
  while (!stepper.done() && std::holds_alternative<Step>(outcome = stepper.advance())) {
  }
  ASSERT_TRUE(std::holds_alternative<assembly::Failure>(outcome));
  EXPECT_LT(stepper.state().load, 1.0);
  const auto& failure = std::get<assembly::Failure>(outcome);
  EXPECT_EQ(failure.kind, assembly::FailureKind::Inverted);
  const auto& at = std::get<assembly::InvertedPoint>(failure.finding).at;
  EXPECT_LT(at.element, static_cast<Index>(m.mesh.triangles.size()));
  EXPECT_GE(at.element, 0);
  EXPECT_EQ(std::get<assembly::LastIncrement>(failure.attempt).converged, stepper.state().load);
}

TEST(LoadStepper, ElasticWorkIsStoredAndItsTrapezoidalErrorFallsWithTheSquareOfTheStep) {
  double last = 0.0;
  for (const int steps : {4, 8}) {
    const assembly::Model m = square(-0.2);
    LoadStepper stepper(m, models::in_steps(steps));
    while (!stepper.done()) ASSERT_TRUE(std::holds_alternative<Step>(stepper.advance()));
    const double error = std::fabs(stepper.state().energies.imbalance());
    if (steps == 8) {
      EXPECT_NEAR(last / error, 4.0, 0.4);
    }
    last = error;
    EXPECT_EQ(stepper.solver().seconds().second_opinions, 0);
  }
}

TEST(LoadStepper, HitsOutputsExactly) {
  const assembly::Model m = square(-0.1);
  LoadStepper stepper(m, models::in_steps(3, {0.1, 0.77}));
  std::vector<double> loads;
  while (!stepper.done()) loads.push_back(std::get<Step>(stepper.advance()).load);
  for (const double load : {0.1, 1.0 / 3, 2.0 / 3, 0.77, 1.0})
    EXPECT_NE(std::find(loads.begin(), loads.end(), load), loads.end()) << load;
}

TEST(LoadStepper, AHomogeneousDeformationIsReproduced) {
  assembly::Model m = square(0.0);
  Mat2 A;
  A << 0.05, 0.1, -0.02, -0.08;
  m.prescribed.clear();
  for (const char* on : {"left", "right", "bottom", "top"})
    m.prescribed.push_back(
        {on, geometry::boundary_nodes(m.mesh, on), {true, true}, [A](const Vec2& X, geometry::MaybeSide, double load) {
           return Vec2(load * A * X);
         }});
  LoadStepper stepper(m, models::in_steps(2));
  while (!stepper.done()) ASSERT_TRUE(std::holds_alternative<Step>(stepper.advance()));
  for (const auto& cell : m.cells)
    EXPECT_LT((cell.deformation(stepper.state().displacement) - Mat2::Identity() - A).norm(), 1e-12);
}

}  // namespace
}  // namespace cleft::solve
