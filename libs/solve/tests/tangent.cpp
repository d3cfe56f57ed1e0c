#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "cleft/solve/stepping.hpp"
#include "small_models.hpp"

namespace cleft::solve {
namespace {

using contact::NegativeSide;
using contact::Status;

// Worst difference between a column block of the assembled tangent and central differences of the assembled force,
// relative to the largest entry of the row.
double worst_difference(const assembly::Model& model, const VecX& u, const assembly::State& state,
                        assembly::Assembler& assembler) {
  EXPECT_FALSE(assembler.assemble(u, state.history));
  const assembly::BlockMatrix matrix = assembler.matrix();
  const double h = 1e-6 * model.surfaces.element_size;
  Eigen::MatrixXd exact(u.size(), u.size()), differences(u.size(), u.size());
  for (Eigen::Index k = 0; k < u.size(); ++k) {
    VecX unit = VecX::Zero(u.size());
    unit[k] = 1.0;
    exact.col(k) = matrix.multiply(unit);
    VecX up = u, down = u;
    up[k] += h;
    down[k] -= h;
    EXPECT_FALSE(assembler.assemble(up, state.history));
    const VecX plus = assembler.internal_force();
    EXPECT_FALSE(assembler.assemble(down, state.history));
    differences.col(k) = (plus - assembler.internal_force()) / (2 * h);
  }
  double worst = 0.0;
  for (Eigen::Index r = 0; r < u.size(); ++r)
    worst =
        std::max(worst, (exact.row(r) - differences.row(r)).cwiseAbs().maxCoeff() / exact.row(r).cwiseAbs().maxCoeff());
  return worst;
}

class AssembledTangent : public testing::TestWithParam<NegativeSide> {};

// In mid-slide, a quarter of an increment past a converged state so that no point sits on a kink of the law, with the
// slide partly reversed so that some points stick.
TEST_P(AssembledTangent, MatchesDifferencesOfTheAssembledForceInMidSlide) {
  assembly::Model model = models::block(16, GetParam());
  model.prescribed[1].displacement = [](const Vec2&, geometry::MaybeSide, double load) {
    const double back =
        std::fmax(0.0, load - 0.6);  // a little: points under high pressure stick, the others slide back
    return Vec2((-0.01 * (load - back) + 4e-4 * back) * Vec2::Ones());
  };
  StepControls controls;
  controls.steps = 40;
  LoadStepper stepper(model, controls);
  std::set<Status> seen;
  while (stepper.state().load < 0.66) {
    ASSERT_TRUE(std::holds_alternative<Step>(stepper.advance()));
    const int step = static_cast<int>(std::lround(40 * stepper.state().load));
    if (step != 22 && step != 25 && step != 26) continue;  // sliding, reversing, reversed
    const assembly::State& s = stepper.state();
    const VecX u = s.displacement + 0.37 * (s.displacement - s.previous_displacement);
    assembly::Assembler assembler(model);
    ASSERT_FALSE(assembler.assemble(u, s.history));
    for (const auto& pair : assembler.pairs()) seen.insert(pair.state.traction.status);
    EXPECT_LT(worst_difference(model, u, s, assembler), 1e-6) << "at load " << s.load;
  }
  EXPECT_EQ(seen.size(), 3u) << "stick, slip and open points must all occur";
}

INSTANTIATE_TEST_SUITE_P(Sides, AssembledTangent,
                         testing::Values(NegativeSide::Left, NegativeSide::Right, NegativeSide::Both));

TEST(LoadStepper, ReachesFullLoadOnTheBlockWithTheReactionsOfAnIndependentPrototype) {
  const assembly::Model model = models::block(8, NegativeSide::Left);
  LoadStepper stepper(model, {});
  double fx_half = 0, fy_half = 0;
  int cuts = 0;
  std::size_t iterations = 0;
  int steps = 0;
  while (!stepper.done()) {
    const auto outcome = stepper.advance();
    ASSERT_TRUE(std::holds_alternative<Step>(outcome));
    cuts += std::get<Step>(outcome).cuts;
    iterations += std::get<Step>(outcome).iterations.size();
    ++steps;
    if (std::fabs(stepper.state().load - 0.5) < 1e-9) {
      fx_half = stepper.reactions()[1].x();
      fy_half = stepper.reactions()[1].y();
    }
  }
  EXPECT_EQ(cuts, 0);
  EXPECT_LE(iterations, 4u * static_cast<std::size_t>(steps));
  EXPECT_NEAR(fx_half, -1.780e6, 0.01 * 1.780e6);
  EXPECT_NEAR(fy_half, -15.211e6, 0.01 * 15.211e6);
  EXPECT_NEAR(stepper.reactions()[1].x(), -2.124e6, 0.03 * 2.124e6);
  EXPECT_NEAR(stepper.reactions()[1].y(), -31.29e6, 0.03 * 31.29e6);
}

TEST(LoadStepper, BottomAndTopReactionsBalance) {
  const assembly::Model model = models::block(8, NegativeSide::Right);
  LoadStepper stepper(model, {});
  ASSERT_TRUE(std::holds_alternative<Step>(stepper.advance()));
  const auto r = stepper.reactions();
  EXPECT_LT((r[0] + r[1]).norm(), 1e-7 * r[1].norm());
}

}  // namespace
}  // namespace cleft::solve
