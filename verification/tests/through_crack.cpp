// Through cracks with closed-form answers: stick under compression, sliding under friction, rigid rotation.
#include <numbers>

#include "solved.hpp"

namespace cleft::verification {
namespace {

double number(const std::map<std::string, std::string>& row, const char* key) { return std::stod(row.at(key)); }

TEST(ThroughCrack, SticksAndLeavesTheFieldOfTheUncrackedBodyUpToTheElasticContact) {
  const Solved run = solve("through_crack");
  const double stress = 1e10 / (1 - 0.25 * 0.25) * 1e-5, angle = std::atan2(0.3639702342662, 1.0);
  const double pressure = stress * std::cos(angle) * std::cos(angle),
               shear = stress * std::sin(angle) * std::cos(angle);
  const double compliance = stress / 2e13 / 1e-5;  // of the penalty springs over that of the body
  EXPECT_NEAR(run.at("fy_top", 1.0), -stress, 1.1 * compliance * stress);
  for (const auto& row : profile(run, "joint", 1.0)) {
    EXPECT_EQ(row.at("status"), "stick");
    EXPECT_NEAR(number(row, "tn"), -pressure, 1.5 * compliance * pressure);
    EXPECT_NEAR(std::fabs(number(row, "tt")), shear, 1.5 * compliance * shear);
    EXPECT_EQ(number(row, "slip"), 0.0);
  }
}

TEST(ThroughCrack, SlidesOnlyWhereFrictionIsBelowTheTangentOfItsAngle) {
  // tan 20 degrees = 0.364
  EXPECT_EQ(solve("through_crack", {"crack.joint.friction=0.37"}).at("slipping_points", 1.0), 0.0);
  // below it the upper part, free to move sideways, slides off its load
  const Solved sliding = solve("through_crack", {"crack.joint.friction=0.35"});
  for (const auto& row : profile(sliding, "joint", 1.0)) EXPECT_NE(row.at("status"), "stick");
  EXPECT_LT(std::fabs(sliding.at("fy_top", 1.0)), 1e-3 * 1e5);
}

TEST(Drag, ForceRatioIsTheFrictionCoefficientAtEveryPositionAndTractionsSitOnTheCone) {
  const Solved run = solve("drag");
  const auto load = run.history.column("load"), fx = run.history.column("fx_bottom"),
             fy = run.history.column("fy_bottom");
  int sliding = 0;
  for (std::size_t k = 0; k < load.size(); ++k) {
    if (load[k] < 0.15) continue;
    EXPECT_NEAR(-fx[k] / fy[k], 0.3, 0.3e-5) << "load " << load[k];
    ++sliding;
  }
  EXPECT_GT(sliding, 50);
  for (const auto& row : profile(run, "interface", 1.0)) {
    if (row.at("status") != "slip") continue;
    EXPECT_NEAR(std::fabs(number(row, "tt")), 0.3 * std::fabs(number(row, "tn")), 1e-15 * std::fabs(number(row, "tn")));
    EXPECT_GT(number(row, "slip"), 0.8);
  }
}

void expect_same_after_rotation(const Solved& run, const char* status) {
  const auto before = profile(run, "joint", 0.5), after = profile(run, "joint", 1.0);
  ASSERT_EQ(before.size(), after.size());
  int seen = 0;
  for (const char* key : {"tn", "tt", "gap", "slip"}) {
    double scale = 0.0;
    for (const auto& row : before) scale = std::fmax(scale, std::fabs(number(row, key)));
    for (std::size_t k = 0; k < before.size(); ++k)
      EXPECT_NEAR(number(before[k], key), number(after[k], key), 1e-9 * scale) << key;
  }
  for (std::size_t k = 0; k < before.size(); ++k) {
    const double tn = std::fabs(number(before[k], "tn"));
    seen += before[k].at("status") == status;
    const double friction = std::string(status) == "slip" ? 0.3 : 0.6;
    if (std::fabs(std::fabs(number(before[k], "tt")) - friction * tn) > 1e-8 * friction * tn) {
      EXPECT_EQ(before[k].at("status"), after[k].at("status"));
    }
  }
  EXPECT_GT(seen, 0);
}

TEST(Rotation, LeavesTractionsAndSlipOfASlidingCrackAsTheyAre) {
  const Solved run = solve("rotation");
  expect_same_after_rotation(run, "slip");
  const double pressed = run.at("external_work", 0.5);
  EXPECT_NEAR(run.at("external_work", 1.0), pressed, 1e-8 * pressed) << "a rigid turn does no work";
  EXPECT_LT(std::fabs(run.result.energies.imbalance()), 1e-4 * pressed);
}

TEST(Rotation, LeavesTractionsOfAStickingCrackAsTheyAre) {
  expect_same_after_rotation(solve("rotation", {"crack.joint.friction=0.6"}), "stick");
}

TEST(Plain, WithoutACrackNothingOfContactIsThereAndTheFactorisationIsSymmetric) {
  const Solved run = solve("plain");
  const std::string json = scene::read_bytes(run.directory + "/run.json");
  EXPECT_NE(json.find("\"factorisation\": \"symmetric\""), std::string::npos);
  EXPECT_NE(json.find("\"enriched\": 0"), std::string::npos);
  EXPECT_NE(json.find("\"contact_points\": 0"), std::string::npos);
  EXPECT_LT(std::fabs(run.result.energies.imbalance()), 1e-4 * run.result.energies.external_work);
}

}  // namespace
}  // namespace cleft::verification
