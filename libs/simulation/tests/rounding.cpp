// What is said, and what is refused, where rounding ends iterations.
#include <fmt/format.h>

#include <cmath>

#include "cleft/support/files.hpp"
#include "runs.hpp"
#include "scene/tests/scenes.hpp"

namespace cleft::simulation {
namespace {

// Two blocks on springs that transmit 20 kN/m while they slide forth and back: however stiff the blocks are, the force
// is displacement / (height / E' + 1 / penalty), E' = E / (1 - nu^2).
std::string joint(double young, const char* kinematics) {
  return fmt::format(R"(
[mesh]
box = [0.0, 0.0, 1.0, 2.0]
cells = [4, 9]
[material]
model = "hencky"
young = {}
poisson = 0.3
[formulation]
kinematics = "{}"
[[crack]]
name = "joint"
points = [[0.0, 1.0], [1.0, 1.0]]
friction = 0.4
contact = {{ normal_penalty = 2.0e10, tangential_penalty = 2.0e10 }}
[[boundary]]
on = "bottom"
ux = 0.0
uy = 0.0
[[boundary]]
on = "top"
name = "slide"
ux = 1.0e-5
amplitude = [[0.0, 0.0], [0.25, 0.0], [0.5, 1.0], [1.0, -1.0]]
[[boundary]]
on = "top"
name = "press"
uy = -1.0e-6
amplitude = [[0.0, 0.0], [0.25, 1.0], [1.0, 1.0]]
[loading]
steps = 64
outputs = [1.0]
)",
                     young, kinematics);
}

bool says(const RunResult& result, const std::string& what) {
  return std::ranges::any_of(result.remarks,
                             [&](const std::string& remark) { return remark.find(what) != std::string::npos; });
}

TEST(Rounding, LeavesSmallStrainsOfStiffBlocksTheirDigits) {
  const Folder folder;
  for (const int steps : {16, 64, 256}) {
    const auto result =
        run(scene_of(joint(2.0e18, "small"), {fmt::format("loading.steps={}", steps)}), into(folder / "run"));
    ASSERT_EQ(result.end, RunResult::End::Done) << result.reason;
    const auto history = read_csv(folder / "run/history.csv");
    const auto load = history.column("load"), force = history.column("fy_press");
    for (std::size_t k = 0; k < load.size(); ++k)
      EXPECT_NEAR(force[k], -20000.0 * std::min(1.0, load[k] / 0.25), 0.02) << "load " << load[k];
    EXPECT_NEAR(std::fabs(history.column("fx_slide").back()), 0.4 * 20000.0, 0.02);
    EXPECT_EQ(result.rounded.increments, 0);
    EXPECT_LT(result.worst_residual, 1e-5);
  }
}

TEST(Rounding, OfMoreThanAHundredthOfTheForcesIsAFailure) {
  const Folder folder;
  const auto result = run(scene_of(joint(2.0e18, "finite")), into(folder / "run"));
  ASSERT_EQ(result.end, RunResult::End::Failed);
  EXPECT_NE(result.reason.find("rounding leaves a residual of "), std::string::npos) << result.reason;
  EXPECT_NE(result.advice.find("formulation.kinematics = \"small\""), std::string::npos);
}

TEST(Rounding, OfLessIsRemarkedOn) {
  const Folder folder;
  const auto result = run(scene_of(joint(2.0e14, "finite")), into(folder / "run"));
  ASSERT_EQ(result.end, RunResult::End::Done) << result.reason;
  EXPECT_GT(result.rounded.increments, 0);
  EXPECT_GT(result.rounded.worst, 1e-5);
  EXPECT_LT(result.rounded.worst, 1e-2);
  EXPECT_GT(result.rounded.load, 0.0);
  EXPECT_TRUE(says(result, fmt::format("rounding ended {} of the increments", result.rounded.increments)));
  EXPECT_NEAR(read_csv(folder / "run/history.csv").column("fy_press").back(), -20000.0, 20.0);

  const auto soft = run(scene_of(joint(2.0e11, "finite")), into(folder / "soft"));
  ASSERT_EQ(soft.end, RunResult::End::Done);
  EXPECT_EQ(soft.rounded.increments, 0);
  EXPECT_FALSE(says(soft, "rounding"));
}

TEST(Rounding, OfABodyWithoutContactIsRemarkedOnLikewise) {
  const Folder folder;
  const auto result =
      run(scene_of(kPlain + "[[boundary]]\non = \"top\"\nux = 0.0\nuy = -1e-13\n"), into(folder / "run"));
  ASSERT_EQ(result.end, RunResult::End::Done) << result.reason;
  EXPECT_GT(result.rounded.increments, 0);
  EXPECT_TRUE(says(result, "rounding ended "));
}

TEST(Rounding, IsCountedOverAllPartsOfARun) {
  const Folder folder;
  const problem::Specification scene = scene_of(joint(2.0e14, "finite"), {"loading.steps=16"});
  const auto whole = run(scene, into(folder / "whole")), parts = run_step_by_step(scene, folder / "parts");
  EXPECT_GT(whole.rounded.increments, 0);
  EXPECT_EQ(parts.rounded.increments, whole.rounded.increments);
  EXPECT_EQ(parts.rounded.worst, whole.rounded.worst);
  EXPECT_EQ(parts.rounded.load, whole.rounded.load);
  EXPECT_EQ(read_bytes(folder / "parts/history.csv"), read_bytes(folder / "whole/history.csv"));
}

// A body that is turned rigidly, one that is held, and one that is unloaded: all of its forces are rounding, or were
// larger before.
TEST(Rounding, IsNoFaultOfABodyThatBearsNothing) {
  const std::string crack = "[[crack]]\nname = \"c\"\npoints = [[0.0, 0.031], [0.04, 0.043]]\nfriction = 0.3\n";
  const std::string springs = "contact = { method = \"penalty\" }\n";
  const std::string turned =
      "[[boundary]]\non = \"top\"\nux = 0.0\nuy = 0.0\nrotation = { center = [0.02, 0.0], degrees = 30.0 }\n";
  const std::string unloaded =
      "[[boundary]]\non = \"top\"\nux = 1e-5\nuy = -1e-4\namplitude = [[0, 0], [0.3, 1], [0.6, 0], [1, 0]]\n";
  const std::string opened = "[[boundary]]\non = \"top\"\nux = 0.0\nuy = 1e-3\n";
  const std::string held = "ux = 0.0\nuy = 0.0\n";
  const std::string turning = held + "rotation = { center = [0.02, 0.0], degrees = 30.0 }\n";
  const std::string small = "[formulation]\nkinematics = \"small\"\n";
  const Folder folder;
  const std::string base = kPlain + "[loading]\nsteps = 10\n";
  int runs = 0;
  for (const std::string& contact : {std::string(), crack, crack + springs})
    for (const std::string& scene : {replaced(base, held, turning) + contact + turned, base + contact + unloaded,
                                     base + contact + unloaded + small}) {
      const auto result = run(scene_of(scene), into(folder / fmt::format("run{}", runs++)));
      EXPECT_EQ(result.end, RunResult::End::Done) << result.reason << scene;
      EXPECT_EQ(result.cuts, 0) << scene;
    }
  const auto apart = run(scene_of(base + crack + opened), into(folder / "apart"));
  EXPECT_EQ(apart.end, RunResult::End::Done) << apart.reason;
}

TEST(Rounding, ThatIsAllThereIsOfForcesIsRemarkedOn) {
  const Folder folder;
  const auto result = run(scene_of(kPlain + "[[boundary]]\non = \"top\"\nuy = -1e-19\n"), into(folder / "run"));
  ASSERT_EQ(result.end, RunResult::End::Done);
  EXPECT_TRUE(says(result, "no force of this run, up to "));
}

}  // namespace
}  // namespace cleft::simulation
