// Sliding by many element lengths: Coulomb's ratio of the forces, and indifference to rigid rotation.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "comparison.hpp"
#include "solved.hpp"

namespace cleft::verification {
namespace {

struct Drag {
  const char* name;
  double friction, way;
};
class Dragged : public testing::TestWithParam<Drag> {};

TEST_P(Dragged, ForceRatioIsTheFrictionCoefficientAtEveryPositionAndTractionsSitOnTheCone) {
  const auto& [name, friction, way] = GetParam();
  Case table(std::string("drag by 10 h, ") + name);
  const Solved run = solve(
      "drag", {"crack.interface.friction=" + std::to_string(friction), "boundary.top_along.ux=" + std::to_string(way)});
  const auto load = run.history.column("load"), fx = run.history.column("fx_bottom"),
             fy = run.history.column("fy_bottom");
  std::vector<double> ratio;
  for (std::size_t k = 0; k < load.size(); ++k)
    if (load[k] >= 0.15) ratio.push_back(-way * fx[k] / fy[k]);
  EXPECT_GT(ratio.size(), 50U);
  table.compare("force ratio, worst position", farthest(ratio, friction), exact(friction),
                within_part(1e-5, "the faces are tilted by strains of 1e-6 and penetrate by 1e-6 h"));
  std::vector<double> on_cone;
  for (const Row& row : run.profile("interface", 1.0)) {
    if (row.at("status") != "slip") continue;
    on_cone.push_back(std::fabs(number(row, "tt") / number(row, "tn")));
    EXPECT_GT(number(row, "slip"), 0.8);
  }
  EXPECT_GT(on_cone.size(), 20U);
  table.compare("traction ratio, worst point", farthest(on_cone, friction), exact(friction),
                within(1e-15 * std::fmax(1.0, friction), "rounding of one product: the law puts them on the cone"));
}

INSTANTIATE_TEST_SUITE_P(Ways, Dragged, testing::Values(Drag{"mu 0.3", 0.3, 1.0}, Drag{"mu 0.7, backwards", 0.7, -1.0}),
                         [](const auto& d) { return d.param.way > 0.0 ? "Forth" : "Back"; });

void expect_same_after_rotation(const Solved& run, Case& table, double friction, const std::string& status) {
  const auto before = run.profile("joint", 0.5), after = run.profile("joint", 1.0);
  ASSERT_EQ(before.size(), after.size());
  for (const char* key : {"tn", "tt", "gap", "slip"}) {
    double scale = 0.0, change = 0.0;
    for (std::size_t k = 0; k < before.size(); ++k) {
      scale = std::fmax(scale, std::fabs(number(before[k], key)));
      change = std::fmax(change, std::fabs(number(before[k], key) - number(after[k], key)));
    }
    table.compare(std::string("change of ") + key + " over its largest", scale > 0.0 ? change / scale : change,
                  exact(0), within(1e-9, "the law is objective: what the iteration at residuals of 1e-12 leaves"));
  }
  int seen = 0, changed = 0;
  for (std::size_t k = 0; k < before.size(); ++k) {
    const double strength = friction * std::fabs(number(before[k], "tn"));
    const bool on_the_cone = std::fabs(std::fabs(number(before[k], "tt")) - strength) <= 1e-8 * strength;
    seen += before[k].at("status") == status;
    changed += !on_the_cone && before[k].at("status") != after[k].at("status");
  }
  EXPECT_GT(seen, 0) << "the case is about points that " << status;
  table.compare("points off the cone that change status", changed, exact(0),
                within(0, "only on the cone rounding may tell stick from slip"));
}

// Contact by the default method, and by mortar with and without smoothing.
class Rotation : public testing::TestWithParam<const char*> {
 protected:
  static Solved turned(double friction) {
    std::vector<std::string> overrides{fmt::format("crack.joint.friction={}", friction)};
    if (*GetParam() != '\0') overrides.push_back(fmt::format("crack.joint.contact={{{}}}", GetParam()));
    return solve("rotation", overrides);
  }
};

TEST_P(Rotation, LeavesTractionsAndSlipOfASlidingCrackAsTheyAre) {
  Case table(fmt::format("rotation by 90 deg, sliding {}", GetParam()));
  const Solved run = turned(0.3);
  expect_same_after_rotation(run, table, 0.3, "slip");
  const double pressed = run.at("external_work", 0.5);
  table.compare("work of the turn over that before", run.at("external_work", 1.0) / pressed - 1.0, exact(0),
                within(1e-8, "a rigid turn does no work: trapezoidal sums of forces that turn"));
  table.compare("energy unaccounted for, over work", run.result.energies.imbalance() / pressed, exact(0),
                within(2e-4, "trapezoidal sums of work and friction over 10 increments: 2.6e-5 over 40"));
}

TEST_P(Rotation, LeavesTractionsOfAStickingCrackAsTheyAre) {
  Case table(fmt::format("rotation by 90 deg, sticking {}", GetParam()));
  expect_same_after_rotation(turned(0.6), table, 0.6, "stick");
}

INSTANTIATE_TEST_SUITE_P(Methods, Rotation, testing::Values("", "method='mortar'", "method='mortar',smoothing=0"),
                         [](const auto& method) {
                           const std::string name = method.param;
                           return name.empty() ? "Default" : name.ends_with("0") ? "ExactMortar" : "Mortar";
                         });

}  // namespace
}  // namespace cleft::verification
