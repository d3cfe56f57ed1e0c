// The block's increments converge quadratically, on every mesh and whichever face is integrated.
#include "cleft/tangent_check/newton_rate.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "comparison.hpp"
#include "solved.hpp"

namespace cleft::verification {
namespace {

class NewtonRate : public testing::TestWithParam<std::tuple<int, const char*>> {};

TEST_P(NewtonRate, IsQuadraticInNineOfTenIncrements) {
  const auto& [across, side] = GetParam();
  Case table(fmt::format("block, {} across, {}, iterations", across, side));
  const problem::Specification scene = scene_of("block", {fmt::format("mesh.cells=[{},{}]", across, 2 * across),
                                                          std::string("crack.main.negative_side=") + side});
  const Solved run = solve(tangent_check::until_rounding(scene));
  const auto verdict = tangent_check::judge(tangent_check::newton_rates(*run.directory), {});
  EXPECT_EQ(verdict.answer, tangent_check::RateAnswer::Holds) << verdict.reason;
  EXPECT_EQ(verdict.increments, 52U);
  table.compare("share of the judged increments that are quadratic",
                static_cast<double>(verdict.reach()) / static_cast<double>(verdict.judged()), exact(1.0),
                within(0.1, "three errors show an order only about"));
  table.compare("lowest order", verdict.orders.front(), exact(2.0), within(0.5, "the same, on the worst increment"));
}

INSTANTIATE_TEST_SUITE_P(Meshes, NewtonRate,
                         testing::Combine(testing::Values(8, 16, 32), testing::Values("left", "right")),
                         [](const auto& c) {
                           return std::to_string(std::get<0>(c.param)) + "_" + std::get<1>(c.param);
                         });

struct Yielding {
  const char *name, *scene, *cells;
  int steps;
};
class YieldingNewtonRate : public testing::TestWithParam<Yielding> {};

TEST_P(YieldingNewtonRate, IsQuadraticInNineOfTenIncrements) {
  const Yielding& p = GetParam();
  Case table(fmt::format("{}, {} cells, {} steps, iterations", p.scene, p.cells, p.steps));
  const auto scene =
      scene_of(p.scene, {fmt::format("mesh.cells={}", p.cells), fmt::format("loading.steps={}", p.steps)});
  const Solved run = solve(tangent_check::until_rounding(scene));
  const auto verdict = tangent_check::judge(tangent_check::newton_rates(*run.directory), {});
  EXPECT_EQ(verdict.answer, tangent_check::RateAnswer::Holds) << verdict.reason;
  table.compare("share of the judged increments that are quadratic",
                static_cast<double>(verdict.reach()) / static_cast<double>(verdict.judged()), exact(1.0),
                within(0.1, "three errors show an order only about"));
}

INSTANTIATE_TEST_SUITE_P(Scenes, YieldingNewtonRate,
                         testing::Values(Yielding{"small_16", "block_yield_small", "[16,32]", 50},
                                         Yielding{"small_32", "block_yield_small", "[32,64]", 50},
                                         Yielding{"finite_8", "block_yield_finite", "[8,16]", 50},
                                         Yielding{"finite_16", "block_yield_finite", "[16,32]", 50},
                                         Yielding{"finite_16_short", "block_yield_finite", "[16,32]", 200}),
                         [](const auto& p) { return p.param.name; });

// No scene that is sound gets a false alarm. Where nothing can be told the reason is that of its few increments.
struct Sound {
  const char* scene;
  std::vector<std::string> overrides{};
  bool may_be_unknown = false;
};
class SoundScene : public testing::TestWithParam<Sound> {};

TEST_P(SoundScene, IsNoFalseAlarm) {
  const auto& [name, overrides, may_be_unknown] = GetParam();
  const Solved run = solve(tangent_check::until_rounding(scene_of(name, overrides)));
  const auto verdict = tangent_check::judge(tangent_check::newton_rates(*run.directory), {});
  using tangent_check::RateAnswer;
  EXPECT_NE(verdict.answer, RateAnswer::Misses) << verdict.reason;
  EXPECT_TRUE(verdict.answer == RateAnswer::Holds || (may_be_unknown && !verdict.reason.empty())) << verdict.reason;
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, SoundScene,
    testing::Values(Sound{"block_small_scale_yield", {"mesh.cells=[16,32]"}},
                    Sound{"closed_crack", {"mesh.cells=[20,20]"}}, Sound{"drag", {"mesh.cells=[20,5]"}},
                    Sound{"footing", {"mesh.cells=[16,8]"}}, Sound{"homogeneous"}, Sound{"manufactured"},
                    Sound{"manufactured_cut"}, Sound{"plain", {"mesh.cells=[8,16]"}},
                    Sound{"plate_crack", {"mesh.cells=[26,38]"}}, Sound{"punch", {"mesh.cells=[16,8]"}},
                    Sound{"ring", {"mesh.size=0.2"}}, Sound{"rotation"}, Sound{"slanted_crack", {"mesh.cells=[28,28]"}},
                    Sound{"slope", {"mesh.size=1.5"}}, Sound{"squeezed"},
                    Sound{"straight_wings", {"mesh.size=24.0", "mesh.crack_size=0.12", "mesh.tip_size=0.06"}, true},
                    Sound{"through_crack"}, Sound{"uniaxial"}, Sound{"wing_crack"}),
    [](const auto& s) { return std::string(s.param.scene); });

}  // namespace
}  // namespace cleft::verification
