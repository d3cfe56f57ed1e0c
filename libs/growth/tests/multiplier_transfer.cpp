// Mortar contact on cracks that grow.
#include <gtest/gtest.h>

#include "bodies.hpp"
#include "cleft/geometry/advance.hpp"
#include "cleft/growth/transfer.hpp"

namespace cleft::growth {
namespace {

// A crack through the middle that has slid under pressure.
struct Slid {
  bodies::Square square;
  assembly::Model model;
  assembly::State state;

  Slid() {
    square.top = {-0.004, -0.01};
    square.cracks = {{"main", {{0.31, 0.42}, {0.68, 0.61}}}};
    square.cells = {16, 16};
    square.mortar = true;
    model = square();
    solve::LoadStepper stepper(model, bodies::in_steps(4));
    while (!stepper.done()) EXPECT_EQ(stepper.advance().index(), 0u);
    state = stepper.state();
  }
};

TEST(MultiplierTransfer, ToTheSameCrackChangesNothing) {
  const Slid slid;
  const auto& before = slid.state.history.multipliers;
  const auto after = transfer(slid.model, slid.state, slid.model);
  EXPECT_EQ(after.history.multipliers.status, before.status);
  EXPECT_LT((after.history.multipliers.multiplier - before.multiplier).norm(), 1e-12 * before.multiplier.norm());
  EXPECT_LT((after.displacement - slid.state.displacement).norm(), 1e-14);
  EXPECT_EQ(after.history.multipliers.slope.size(), before.slope.size());
  double most = 0.0;
  for (std::size_t i = 0; i < before.slope.size(); ++i) {
    EXPECT_NEAR(after.history.multipliers.slope[i], before.slope[i], 1e-12);
    EXPECT_NEAR(after.history.multipliers.smooth[i], before.smooth[i], 1e-20);
    EXPECT_NEAR(after.history.multipliers.state[i].slip, before.state[i].slip, 1e-15);
    most = std::max(most, before.state[i].slip);
  }
  EXPECT_GT(most, 1e-6) << "nodes must have slid";
  EXPECT_EQ(after.history.multipliers.stored, before.stored);
  ASSERT_EQ(after.history.multipliers.anchor_maps.size(), before.anchor_maps.size());
  for (std::size_t k = 0; k < before.anchor_maps.size(); ++k) {
    const auto &a = after.history.multipliers.anchor_maps[k], &b = before.anchor_maps[k];
    EXPECT_EQ(a.face, b.face);
    EXPECT_EQ(a.anchor_face, b.anchor_face);
    EXPECT_NEAR(a.begin, b.begin, 1e-10);
    EXPECT_NEAR(a.anchor_begin, b.anchor_begin, 1e-10);
    EXPECT_NEAR(a.anchor_end, b.anchor_end, 1e-10);
  }
}

TEST(MultiplierTransfer, ToALongerCrackKeepsTractionsWhereTheyAreAndPutsNewHatsAtRest) {
  const Slid slid;
  const double old_length = (Vec2(0.68, 0.61) - Vec2(0.31, 0.42)).norm();
  const auto longer = slid.square({geometry::extended(slid.square.cracks[0], 1, {0.7, 0.78})});
  const auto state = transfer(slid.model, slid.state, longer);
  const auto traction_at = [](const assembly::Model& m, const VecX& multiplier, double s) -> Vec2 {
    const auto& space = m.surfaces.multiplier_space;
    for (const auto& e : space.intervals) {
      const double first = space.nodes[e.first].s, second = space.nodes[e.second].s;
      if (s < first || s > second) continue;
      const double share = (s - first) / (second - first);
      return (1.0 - share) * multiplier.segment<2>(2 * e.first) + share * multiplier.segment<2>(2 * e.second);
    }
    return Vec2::Zero();
  };
  int kept = 0, fresh = 0;
  const auto& space = longer.surfaces.multiplier_space;
  for (std::size_t i = 0; i < space.nodes.size(); ++i) {
    const double s = space.nodes[i].s;
    const Vec2 now = state.history.multipliers.multiplier.segment<2>(2 * static_cast<Index>(i));
    if (s > old_length) {
      EXPECT_EQ(now.norm(), 0.0);
      ++fresh;
    } else if (s < old_length - 0.1) {
      const Vec2 was = traction_at(slid.model, slid.state.history.multipliers.multiplier, s);
      EXPECT_LT((now - was).norm(), 1e-9 * (1.0 + was.norm()));
      EXPECT_LT(now.x(), 0.0);
      ++kept;
    }
  }
  EXPECT_GT(kept, 2);
  EXPECT_GE(fresh, 2);

  solve::LoadStepper stepper(longer, bodies::in_steps(4));
  stepper.restore(state, {});
  EXPECT_EQ(stepper.equilibrate().index(), 0u);
}

}  // namespace
}  // namespace cleft::growth
